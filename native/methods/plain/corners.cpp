#include "methods/plain/corners.h"

#include <algorithm>
#include <glm/common.hpp>

namespace gradmesh {
namespace {

/// Returns how much is seen of the corner at a point of a line between two straight sides, of which
/// `made_straight` counts as one; 0 where there is none, or where the line was not smooth.
double corner_at(const PlainGrid& grid, Along along, int row, int column,
                 const Side* made_straight = nullptr) {
  const int down = along == Along::columns, right = along == Along::rows;
  const bool is_inside =
      right ? column > 0 && column < grid.columns() : row > 0 && row < grid.rows();
  if (!is_inside || !grid.is_smooth(along, row, column)) return 0;
  const auto is_curve = [&](const Side& side) {
    return grid.bend(side.along, side.row, side.column) &&
           !(made_straight && *made_straight == side);
  };
  if (is_curve({along, row, column}) || is_curve({along, row - down, column - right})) return 0;
  double contrast = 0;
  for (const int beside : {-1, 1}) {
    const int i = row + beside * right, j = column + beside * down;
    if (i < 0 || j < 0 || i > grid.rows() || j > grid.columns()) continue;
    const glm::dvec4 d = glm::abs(grid.knot(i, j).color - grid.knot(row, column).color);
    contrast = std::max({contrast, d.r, d.g, d.b, d.a});
  }
  return contrast * grid.turn_of_chords(along, row, column);
}

}  // namespace

double largest_corner(const PlainGrid& grid) {
  double most = 0;
  for (const Along along : {Along::rows, Along::columns})
    for (int i = 0; i <= grid.rows(); ++i)
      for (int j = 0; j <= grid.columns(); ++j) most = std::max(most, corner_at(grid, along, i, j));
  return most;
}

bool makes_corner(const PlainGrid& grid, const Side& side) {
  const int down = side.along == Along::columns, right = side.along == Along::rows;
  return corner_at(grid, side.along, side.row, side.column, &side) > seen_corner ||
         corner_at(grid, side.along, side.row + down, side.column + right, &side) > seen_corner;
}

}  // namespace gradmesh
