#include "methods/plain/steps.h"

#include <algorithm>

namespace gradmesh {
namespace {

/// Farther points hardly move, and a fit of few points is quicker.
constexpr int reach = 3;

}  // namespace

std::vector<Side> curved_sides(const PlainGrid& grid) {
  std::vector<Side> sides;
  for (const Along along : {Along::rows, Along::columns})
    for (int i = 0; i <= grid.rows() - (along == Along::columns); ++i)
      for (int j = 0; j <= grid.columns() - (along == Along::rows); ++j)
        if (grid.bend(along, i, j) && !grid.is_fixed_side(along, i, j))
          sides.push_back({along, i, j});
  return sides;
}

void make(const Step& step, PlainGrid& grid) {
  for (const Side& side : step.sides) grid.bend(side.along, side.row, side.column).reset();
  if (step.takes_line()) grid.take_out(step.along, step.line);
}

GridPoints points_near(const Step& step, const PlainGrid& after) {
  GridPoints points(after);
  const int rows = after.rows(), columns = after.columns();
  if (step.takes_line()) {
    const int first = step.line - reach, last = step.line - 1 + reach;
    if (step.along == Along::rows)
      points.add({first, last, 0, columns});
    else
      points.add({0, rows, first, last});
  }
  for (const auto& [along, row, column] : step.sides)
    points.add({row - reach, row + (along == Along::columns) + reach, column - reach,
                column + (along == Along::rows) + reach});
  return points;
}

}  // namespace gradmesh
