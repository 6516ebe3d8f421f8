#include "methods/plain/steps.h"

#include <algorithm>

namespace gradmesh {
namespace {

/// Farther points hardly move, and a fit of few points is quicker.
constexpr int reach = 3;

GridPoints within(const GridPoints& points, const PlainGrid& grid) {
  return {std::max(points.first_row, 0), std::min(points.last_row, grid.rows()),
          std::max(points.first_column, 0), std::min(points.last_column, grid.columns())};
}

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
  GridPoints points = GridPoints::all(after);
  if (step.takes_line()) {
    const bool is_row = step.along == Along::rows;
    (is_row ? points.first_row : points.first_column) = step.line - reach;
    (is_row ? points.last_row : points.last_column) = step.line - 1 + reach;
  } else if (step.sides.size() == 1) {
    const auto& [along, row, column] = step.sides.front();
    points = {row - reach, row + (along == Along::columns) + reach, column - reach,
              column + (along == Along::rows) + reach};
  }
  return within(points, after);
}

}  // namespace gradmesh
