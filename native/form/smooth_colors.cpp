#include "form/smooth_colors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "mesh/build.h"
#include "mesh/rectangle.h"

namespace gradmesh {
namespace {

/// The number of parts each way into which Inkscape divides a patch.
constexpr int parts_per_side = 8;

using Corner = SmoothColors::Corner;

double inner_slope(double before, double here, double after, double distance, double next) {
  if (!(distance > 0 && next > 0)) return 0;
  const double in = (here - before) / distance, out = (after - here) / next;
  if (in * out < 0) return 0;
  double slope = 0.5 * (in + out);
  for (const double one_sided : {in, out})
    if (std::abs(slope) > 3 * std::abs(one_sided)) slope = 3 * one_sided;
  return slope;
}

/// Returns the slope at the end of a line that makes a parabola of its last part, `slope` being
/// that at the part's other end.
glm::dvec3 end_slope(const glm::dvec3& difference, double distance, const glm::dvec3& slope) {
  return distance > 0 ? 2.0 * difference / distance - slope : glm::dvec3(0);
}

/// Returns the slopes of the colours at the corners along a line, by Inkscape's rule.
std::vector<glm::dvec3> slopes(const std::vector<Corner>& line) {
  const std::size_t last = line.size() - 1;
  std::vector<glm::dvec3> result(line.size(), glm::dvec3(0));
  const auto distance = [&](std::size_t i) {
    return glm::distance(line[i].position, line[i + 1].position);
  };
  const auto difference = [&](std::size_t i) { return line[i + 1].color - line[i].color; };
  for (std::size_t i = 1; i < last; ++i)
    for (int k = 0; k < 3; ++k)
      result[i][k] = inner_slope(line[i - 1].color[k], line[i].color[k], line[i + 1].color[k],
                                 distance(i - 1), distance(i));
  // In this order: along a line of one part the first takes 0 for the last, and the last the first.
  result[0] = end_slope(difference(0), distance(0), result[1]);
  result[last] = end_slope(difference(last - 1), distance(last - 1), result[last - 1]);
  return result;
}

/// Replaces the tangents of the colours, without opacity: `down[i][j]` is the slope along u at the
/// corner (i, j) of the patch, `right[i][j]` that along v.
using Slopes = std::array<std::array<glm::dvec3, 2>, 2>;
void set_color_slopes(Patch& patch, const Slopes& down, const Slopes& right) {
  auto& c = patch.c;
  const auto set = [](Value& value, const glm::dvec3& color) {
    value.color = glm::dvec4(color, value.color.a);
  };
  for (int k : {0, 1}) {
    const int at = 3 * k;
    const double along_u = glm::distance(c[0][at].position, c[3][at].position);
    const double along_v = glm::distance(c[at][0].position, c[at][3].position);
    for (int end : {0, 1}) {
      set(c[1 + end][at], down[end][k] * along_u);
      set(c[at][1 + end], right[k][end] * along_v);
    }
  }
  for (int i : {1, 2})
    for (int j : {1, 2}) set(c[i][j], glm::dvec3(0));
}

std::vector<Corner> corners_of(const Mesh& mesh, const Rectangle& grid) {
  std::vector<Corner> corners;
  for (int i = 0; i <= grid.rows; ++i)
    for (int j = 0; j <= grid.columns; ++j) {
      const bool below = i == grid.rows, beside = j == grid.columns;
      Halfedge at = grid.top(i - below, j - beside);
      if (below) at = mesh.prev(at);
      if (beside) at = below ? mesh.prev(at) : mesh.next(at);
      corners.push_back({mesh.position(mesh.origin(at)), glm::dvec3(mesh[at].color)});
    }
  return corners;
}

class SmoothGrid {
 public:
  explicit SmoothGrid(const Mesh& mesh)
      : mesh_(mesh),
        grid_(find_grid(mesh).value()),
        colors_(grid_.rows, grid_.columns, corners_of(mesh, grid_)) {}

  int rows() const { return grid_.rows; }
  int columns() const { return grid_.columns; }

  Patch patch(int row, int column) const {
    Patch patch = mesh_.patch(grid_.top(row, column));
    colors_.apply(patch, row, column);
    return patch;
  }

 private:
  const Mesh& mesh_;
  const Rectangle grid_;
  const SmoothColors colors_;
};

/// Colours at the corners of a patch's parts.
using PartColors = std::array<std::array<glm::dvec4, parts_per_side + 1>, parts_per_side + 1>;

PartColors part_colors(const Patch& patch) {
  PartColors colors;
  for (int i = 0; i <= parts_per_side; ++i)
    for (int j = 0; j <= parts_per_side; ++j)
      colors[i][j] = glm::clamp(
          patch.at(double(i) / parts_per_side, double(j) / parts_per_side).color, 0.0, 1.0);
  return colors;
}

/// Appends row i of the parts of a patch, from left to right.
void append_row(const Patch& patch, const PartColors& colors, int i, std::vector<Patch>& parts) {
  const Patch row = patch.part_u(double(i) / parts_per_side, double(i + 1) / parts_per_side);
  for (int j = 0; j < parts_per_side; ++j) {
    Patch part = row.part_v(double(j) / parts_per_side, double(j + 1) / parts_per_side);
    for (std::size_t a : {0, 1})
      for (std::size_t b : {0, 1})
        part.c[3 * a][3 * b].color = colors[std::size_t(i) + a][std::size_t(j) + b];
    make_color_bilinear(part);
    parts.push_back(part);
  }
}

}  // namespace

SmoothColors::SmoothColors(int rows, int columns, std::span<const Corner> corners) {
  const auto corner = [&](int i, int j) { return corners[std::size_t(i * (columns + 1) + j)]; };
  for (int i = 0; i <= rows; ++i) {
    std::vector<Corner> line;
    for (int j = 0; j <= columns; ++j) line.push_back(corner(i, j));
    right_.push_back(slopes(line));
  }
  for (int j = 0; j <= columns; ++j) {
    std::vector<Corner> line;
    for (int i = 0; i <= rows; ++i) line.push_back(corner(i, j));
    down_.push_back(slopes(line));
  }
}

void SmoothColors::apply(Patch& patch, int row, int column) const {
  make_color_bilinear(patch);
  Slopes down, right;
  for (int i : {0, 1})
    for (int j : {0, 1}) {
      down[i][j] = down_[column + j][row + i];
      right[i][j] = right_[row + i][column + j];
    }
  set_color_slopes(patch, down, right);
}

MeshParts with_smooth_colors(const Mesh& mesh) {
  const SmoothGrid grid(mesh);
  MeshParts parts{{}, grid_curves(grid.rows(), grid.columns()), ColorModel::bicubic};
  for (int row = 0; row < grid.rows(); ++row)
    for (int column = 0; column < grid.columns(); ++column)
      parts.patches.push_back(grid.patch(row, column));
  return parts;
}

Mesh painted_mesh(const Mesh& mesh) {
  const SmoothGrid grid(mesh);
  MeshParts parts{{}, {}, ColorModel::bicubic};
  parts.patches.reserve(std::size_t(parts_per_side * parts_per_side) *
                        std::size_t(mesh.face_count()));
  for (int row = 0; row < grid.rows(); ++row) {
    std::vector<Patch> patches;
    std::vector<PartColors> colors;
    for (int column = 0; column < grid.columns(); ++column) {
      patches.push_back(grid.patch(row, column));
      colors.push_back(part_colors(patches.back()));
    }
    for (int i = 0; i < parts_per_side; ++i)
      for (int column = 0; column < grid.columns(); ++column)
        append_row(patches[column], colors[column], i, parts.patches);
  }
  return build_derived_mesh(parts);
}

std::vector<Face> faces_of_painted_mesh(const Mesh& mesh) {
  const Rectangle grid = find_grid(mesh).value();
  std::vector<Face> faces;
  for (int row = 0; row < grid.rows; ++row)
    for (int i = 0; i < parts_per_side; ++i)
      for (int column = 0; column < grid.columns; ++column)
        faces.insert(faces.end(), parts_per_side, mesh.face(grid.top(row, column)));
  return faces;
}

}  // namespace gradmesh
