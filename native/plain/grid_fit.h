#pragma once

#include "fit/target.h"
#include "plain/plain_grid.h"

namespace gradmesh {

/// Moves the points of a grid, and the tangents of those of its sides that are curves, so that the
/// grid's picture comes close to the target, by least squares in at most `steps` steps of
/// Gauss-Newton. Colours stay, straight sides stay straight, and no patch folds that did not fold.
/// Returns the sum of the squares that is left, each over the area of its sample in pixels.
double fit_grid(PlainGrid& grid, const FitTarget& target, int steps);

/// Returns the same sum for one patch of the grid as it is.
double patch_squares(const PlainGrid& grid, int row, int column, const FitTarget& target);

}  // namespace gradmesh
