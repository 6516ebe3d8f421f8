#include "fit/target.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "raster/hidden.h"

namespace gradmesh {
namespace {

/// Jumps of less than this are not seen as an outline, 0..1.
constexpr double smallest_jump = 0.01;
/// Colours of neighbouring pixels that differ by more than this belong to two surfaces, 0..1.
constexpr double edge_in_picture = 0.06;
/// The distance within which an outline is looked for, and the side of a grid cell, in pixels.
constexpr double reach = 8;

double largest(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

bool jumps(const glm::dvec4& a, const glm::dvec4& b) {
  const glm::dvec4 d = glm::abs(a - b);
  return std::max(largest(glm::dvec3(d)), d.a) > smallest_jump;
}

/// Returns the numbers from 0 to 1 that the levels of 8 bits stand for; divisions take long.
constexpr std::array<double, 256> shares_of_levels() {
  std::array<double, 256> shares{};
  for (std::size_t level = 0; level < shares.size(); ++level) shares[level] = double(level) / 255.0;
  return shares;
}

glm::dvec3 color_of(const Image& image, int x, int y) {
  static constexpr std::array<double, 256> share = shares_of_levels();
  const auto pixel = image.pixel(x, y);
  return {share[pixel[0]], share[pixel[1]], share[pixel[2]]};
}

}  // namespace

bool is_outline(const Mesh& mesh, Halfedge side) {
  const Halfedge twin = mesh[side].twin;
  if (!twin.valid()) return true;
  const Cubic<Value> curve = mesh.curve_of(side), back = mesh.curve_of(twin).reversed();
  return jumps(curve.p0.color, back.p0.color) || jumps(curve.p1.color, back.p1.color);
}

FitTarget::FitTarget(const Mesh& original, const Frame& frame)
    : frame_(frame),
      painting_(paint_whole(original, frame)),
      columns_(int(frame.width / reach) + 1),
      rows_(int(frame.height / reach) + 1),
      cells_(std::size_t(columns_) * std::size_t(rows_)) {
  for (const Halfedge h : original.halfedges())
    if (!original.is_bar(h) && original.curve(h) == h && is_outline(original, h))
      add_outline(original.curve_of(h));
}

std::optional<glm::dvec3> FitTarget::color_at(glm::dvec2 place) const {
  const double x = place.x - 0.5, y = place.y - 0.5;
  const int x0 = int(std::floor(x)), y0 = int(std::floor(y));
  if (x0 < 0 || y0 < 0 || x0 + 1 >= frame_.width || y0 + 1 >= frame_.height) return {};
  const double fx = x - x0, fy = y - y0;
  const int nearest_x = x0 + (fx > 0.5), nearest_y = y0 + (fy > 0.5);
  if (*painting_.top.at(nearest_x, nearest_y) == 0) return {};
  const glm::dvec3 nearest = color_of(painting_.image, nearest_x, nearest_y);
  glm::dvec3 sum(0.0), low = nearest, high = nearest;
  for (const int dy : {0, 1})
    for (const int dx : {0, 1}) {
      const bool is_covered = *painting_.top.at(x0 + dx, y0 + dy) != 0;
      const glm::dvec3 color = is_covered ? color_of(painting_.image, x0 + dx, y0 + dy) : nearest;
      sum += (dx ? fx : 1 - fx) * (dy ? fy : 1 - fy) * color;
      low = glm::min(low, color);
      high = glm::max(high, color);
    }
  return largest(high - low) > edge_in_picture ? nearest : sum;
}

bool FitTarget::is_hidden(glm::dvec2 place) const {
  return frame_.hidden &&
         frame_.hidden->contains(int(std::floor(place.x)), int(std::floor(place.y)));
}

std::optional<FitTarget::OutlinePoint> FitTarget::outline_near(glm::dvec2 place) const {
  const int column = int(std::floor(place.x / reach)), row = int(std::floor(place.y / reach));
  std::optional<OutlinePoint> nearest;
  double least = reach * reach;
  for (int r = std::max(0, row - 1); r <= std::min(rows_ - 1, row + 1); ++r)
    for (int c = std::max(0, column - 1); c <= std::min(columns_ - 1, column + 1); ++c)
      for (const OutlinePoint& p : cells_[std::size_t(r) * columns_ + c]) {
        const glm::dvec2 d = p.place - place;
        if (const double square = glm::dot(d, d); square < least) {
          least = square;
          nearest = p;
        }
      }
  return nearest;
}

std::vector<FitTarget::OutlinePoint>* FitTarget::cell_at(glm::dvec2 place) {
  const int column = int(std::floor(place.x / reach)), row = int(std::floor(place.y / reach));
  if (column < 0 || row < 0 || column >= columns_ || row >= rows_) return nullptr;
  return &cells_[std::size_t(row) * columns_ + column];
}

void FitTarget::add_outline(const Cubic<Value>& curve) {
  const Cubic<glm::dvec2> line = in_pixels(curve, frame_);
  const double size = glm::length(line.m0) + glm::length(line.m1) + glm::length(line.p1 - line.p0);
  const int steps = std::clamp(int(size), 4, 400);
  for (int i = 0; i <= steps; ++i) {
    const glm::dvec2 place = line.at(double(i) / steps);
    const glm::dvec2 along = line.derivative(double(i) / steps);
    const double speed = glm::length(along);
    std::vector<OutlinePoint>* cell = cell_at(place);
    if (cell && speed > 0) cell->push_back({place, glm::dvec2(-along.y, along.x) / speed});
  }
}

Cubic<glm::dvec2> in_pixels(const Cubic<Value>& curve, const Frame& frame) {
  const Affine& map = frame.to_pixels;
  return {map.point(curve.p0.position), map.vector(curve.m0.position),
          map.vector(curve.m1.position), map.point(curve.p1.position)};
}

}  // namespace gradmesh
