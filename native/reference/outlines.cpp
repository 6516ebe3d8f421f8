#include "reference/outlines.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/clamped_int.h"

namespace gradmesh {
namespace {

/// Jumps of less than this are not seen as an outline, 0..1.
constexpr double smallest_jump = 0.01;
/// The distance within which an outline is looked for, and the side of a grid cell, in pixels.
constexpr int reach = 8;

bool jumps(const glm::dvec4& a, const glm::dvec4& b) {
  const glm::dvec4 d = glm::abs(a - b);
  return std::max({d.r, d.g, d.b, d.a}) > smallest_jump;
}

}  // namespace

bool is_outline(const Mesh& mesh, Halfedge side) {
  const Halfedge twin = mesh[side].twin;
  if (!twin.valid()) return true;
  const Cubic<Value> curve = mesh.curve_of(side), back = mesh.curve_of(twin).reversed();
  return jumps(curve.p0.color, back.p0.color) || jumps(curve.p1.color, back.p1.color);
}

Cubic<glm::dvec2> in_pixels(const Cubic<Value>& curve, const Frame& frame) {
  const Affine& map = frame.to_pixels;
  return {map.point(curve.p0.position), map.vector(curve.m0.position),
          map.vector(curve.m1.position), map.point(curve.p1.position)};
}

OutlinePoints::OutlinePoints(const Mesh& mesh, const Frame& frame)
    : columns_(frame.width / reach + 1),
      rows_(frame.height / reach + 1),
      cells_(std::size_t(columns_) * std::size_t(rows_)) {
  for (const Halfedge h : mesh.curves())
    if (is_outline(mesh, h)) add(in_pixels(mesh.curve_of(h), frame));
}

OutlinePoints::Cell OutlinePoints::cell_of(glm::dvec2 place) const {
  // Far enough outside that nothing of the grid is beside it.
  return {clamped_int(std::floor(place.x / reach), -2, columns_ + 1),
          clamped_int(std::floor(place.y / reach), -2, rows_ + 1)};
}

std::optional<OutlinePoint> OutlinePoints::closest(glm::dvec2 place) const {
  const auto [column, row] = cell_of(place);
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

void OutlinePoints::add(const Cubic<glm::dvec2>& line) {
  const double size = glm::length(line.m0) + glm::length(line.m1) + glm::length(line.p1 - line.p0);
  const int steps = clamped_int(size, 4, 400);
  for (int i = 0; i <= steps; ++i) {
    const glm::dvec2 place = line.at(double(i) / steps);
    const glm::dvec2 along = line.derivative(double(i) / steps);
    const double speed = glm::length(along);
    const auto [column, row] = cell_of(place);
    if (speed > 0 && column >= 0 && row >= 0 && column < columns_ && row < rows_)
      cells_[std::size_t(row) * columns_ + column].push_back(
          {place, glm::dvec2(-along.y, along.x) / speed});
  }
}

}  // namespace gradmesh
