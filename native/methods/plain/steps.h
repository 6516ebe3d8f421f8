#pragma once

#include <vector>

#include "methods/plain/grid_unknowns.h"
#include "methods/plain/plain_grid.h"

namespace gradmesh {

/// A side of a grid, by the point at which it begins.
struct Side {
  Along along;
  int row, column;

  bool operator==(const Side&) const = default;
};

/// Returns the sides of a grid that are curves, but those that must stay as they are.
std::vector<Side> curved_sides(const PlainGrid& grid);

/// A way to make a grid simpler: sides that become straight, or a line of points that is taken out.
struct Step {
  std::vector<Side> sides;
  Along along = Along::rows;
  int line = 0;

  bool takes_line() const { return line > 0; }
};

/// Makes a grid simpler by a step.
void make(const Step& step, PlainGrid& grid);

/// Returns the points of the grid after a step that are to be fitted anew: those within a few lines
/// of one that is gone or of a side that is straight.
GridPoints points_near(const Step& step, const PlainGrid& after);

}  // namespace gradmesh
