#include "methods/plain/border.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "base/clamped_int.h"

namespace gradmesh {
namespace {

/// Returns the gap of border_gap at one side; `farthest` where no outline is near.
double gap_of(const PlainGrid& grid, Along along, int row, int column, const Reference& picture) {
  constexpr double farthest = 10, spacing = 3;
  const Affine& to_pixels = picture.frame().to_pixels;
  const Cubic<glm::dvec2> side = grid.side(along, row, column);
  const double length = glm::length(to_pixels.vector(side.p1 - side.p0));
  const int steps = clamped_int(length / spacing, 4, 100);
  double gap = 0;
  for (int i = 0; i <= steps; ++i) {
    const glm::dvec2 place = to_pixels.point(side.at(double(i) / steps));
    if (picture.is_hidden(place)) continue;
    const auto outline = picture.outline_near(place);
    gap = std::max(gap, outline ? glm::length(place - outline->place) : farthest);
  }
  return gap;
}

}  // namespace

double border_gap(const PlainGrid& grid, const Reference& picture) {
  double gap = 0;
  for (const int row : {0, grid.rows()})
    for (int j = 0; j < grid.columns(); ++j)
      gap = std::max(gap, gap_of(grid, Along::rows, row, j, picture));
  for (const int column : {0, grid.columns()})
    for (int i = 0; i < grid.rows(); ++i)
      gap = std::max(gap, gap_of(grid, Along::columns, i, column, picture));
  return gap;
}

}  // namespace gradmesh
