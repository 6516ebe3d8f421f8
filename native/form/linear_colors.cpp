#include "form/linear_colors.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "mesh/rectangle.h"

namespace gradmesh {
namespace {

bool is_same_color(const glm::dvec4& a, const glm::dvec4& b) {
  return glm::round(a * 255.0) == glm::round(b * 255.0);
}

bool has_one_color(const Mesh& mesh) {
  const glm::dvec4 first = mesh.patch(*mesh.faces().begin()).corner(0).color;
  for (const Face f : mesh.faces())
    for (int k = 0; k < 4; ++k)
      if (!is_same_color(mesh.patch(f).corner(k).color, first)) return false;
  return true;
}

/// A patch whose colours are to change from its left to its right.
struct Across {
  BezierNet net;

  const glm::dvec4& color(int row, int column) const { return net[row][column].color; }
  bool is_constant_down() const {
    return is_same_color(color(0, 0), color(3, 0)) && is_same_color(color(0, 3), color(3, 3));
  }
};

/// Returns the patch of a grid as seen with the direction `along` from left to right.
Across patch_along(const Mesh& mesh, const Rectangle& grid, Along along, int line, int place) {
  const bool rows = along == Along::rows;
  BezierNet net = bezier_net(mesh.patch(rows ? grid.top(line, place) : grid.top(place, line)));
  if (!rows)
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < i; ++j) std::swap(net[i][j], net[j][i]);
  return {net};
}

/// Looks for colours that change along rows, or along columns.
class LinearFinder {
 public:
  LinearFinder(const Mesh& mesh, const Rectangle& grid, Along along, double tolerance)
      : mesh_(mesh),
        grid_(grid),
        along_(along),
        lines_(along == Along::rows ? grid.rows : grid.columns),
        places_(along == Along::rows ? grid.columns : grid.rows),
        tolerance_(tolerance) {}

  std::optional<LinearColors> run() {
    const BezierNet first = patch(0, 0).net, last = patch(lines_ - 1, 0).net;
    const glm::dvec2 edge = last[3][0].position - first[0][0].position;
    if (!(glm::length(edge) > tolerance_)) return std::nullopt;
    direction_ = glm::normalize(glm::dvec2(edge.y, -edge.x));
    if (way(first[0][3].position) < way(first[0][0].position)) direction_ = -direction_;

    const double begin = way(first[0][0].position);
    std::vector<std::pair<double, glm::dvec4>> stops;
    double left = begin;
    for (int place = 0; place < places_; ++place) {
      const Across top = patch(0, place);
      const double right = way(top.net[0][3].position);
      if (!(right - left > tolerance_)) return std::nullopt;
      for (int line = 0; line < lines_; ++line)
        if (!is_linear(patch(line, place), top, left, right)) return std::nullopt;
      for (const int column : {0, 3})
        stops.emplace_back(column == 0 ? left : right, top.color(0, column));
      left = right;
    }
    return colors(first[0][0].position, begin, left, stops);
  }

 private:
  Across patch(int line, int place) const { return patch_along(mesh_, grid_, along_, line, place); }
  double way(glm::dvec2 p) const { return glm::dot(direction_, p); }

  /// Returns true if the patch has the colours of `top` at its sides, and if all its points lie as
  /// far on the way from `left` to `right` as their parameter is.
  bool is_linear(const Across& patch, const Across& top, double left, double right) const {
    if (!patch.is_constant_down()) return false;
    for (const int column : {0, 3})
      if (!is_same_color(patch.color(0, column), top.color(0, column))) return false;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        if (std::abs(way(patch.net[i][j].position) - std::lerp(left, right, j / 3.0)) > tolerance_)
          return false;
    return true;
  }

  std::optional<LinearColors> colors(
      glm::dvec2 start, double begin, double end,
      const std::vector<std::pair<double, glm::dvec4>>& stops) const {
    LinearColors result{start, start + (end - begin) * direction_, {}};
    const auto opacity = [](const glm::dvec4& color) { return std::round(255 * color.a); };
    for (const auto& [at, color] : stops) {
      // Programs differ in how they mix colours of several opacities.
      if (opacity(color) != opacity(stops.front().second)) return std::nullopt;
      const double place = (at - begin) / (end - begin);
      const bool is_known = !result.stops.empty() && result.stops.back().place == place &&
                            is_same_color(result.stops.back().color, color);
      if (!is_known) result.stops.push_back({place, color});
    }
    return result;
  }

  const Mesh& mesh_;
  const Rectangle& grid_;
  const Along along_;
  /// The lines of patches that run along the colours, and the patches of each of them.
  const int lines_, places_;
  const double tolerance_;
  /// The way that the colours go, of length 1.
  glm::dvec2 direction_{0.0};
};

}  // namespace

std::optional<LinearColors> linear_colors(const Mesh& mesh, double tolerance) {
  if (mesh.face_count() == 0) return std::nullopt;
  if (has_one_color(mesh))
    return LinearColors{{}, {}, {{0, mesh.patch(*mesh.faces().begin()).corner(0).color}}};
  const auto grid = mesh.is_smooth() ? std::nullopt : find_grid(mesh);
  if (!grid) return std::nullopt;
  for (const Along along : {Along::rows, Along::columns})
    if (auto found = LinearFinder(mesh, *grid, along, tolerance).run()) return found;
  return std::nullopt;
}

}  // namespace gradmesh
