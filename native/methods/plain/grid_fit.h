#pragma once

#include "methods/plain/grid_unknowns.h"
#include "methods/plain/plain_grid.h"
#include "reference/reference.h"

namespace gradmesh {

/// Moves points of a grid, and the tangents there of those of its sides that are curves, so that
/// the grid's picture comes close to the target, by least squares in at most `steps` steps of
/// Gauss-Newton. Colours stay, straight sides stay straight, and no patch folds or is pinched
/// (flaws.h) that was not. Returns the sum of the squares that is left, each over the area of its
/// sample in pixels, of the patches that the points change.
double fit_grid(PlainGrid& grid, const Reference& target, int steps, const GridPoints& points);
double fit_grid(PlainGrid& grid, const Reference& target, int steps);

/// Fits as fit_grid does, and changes the colours of those points as well that are opaque. These
/// stay whole levels of 8 bits, as an SVG document has them. A colour stays as it is where another
/// one would hardly be better: it is exactly that of the original picture there, and rounding is
/// seen.
void fit_grid_and_colors(PlainGrid& grid, const Reference& target, int steps,
                         const GridPoints& points);

/// A patch of a grid.
struct PatchPlace {
  int row, column;

  auto operator<=>(const PatchPlace&) const = default;
};

/// The sum of the squares, as of fit_grid, that is expected to be left of some patches.
struct ExpectedSquares {
  double squares = 0;
  std::vector<PatchPlace> patches;
};

/// Returns what the first step of fit_grid is expected to leave of the patches that the points
/// change: it is what the equations say, and nothing is moved.
ExpectedSquares expected_squares(PlainGrid grid, const Reference& target, const GridPoints& points);

/// Returns the sum of the squares, as of fit_grid, of one patch of the grid as it is.
double patch_squares(const PaintedGrid& grid, int row, int column, const Reference& target);

}  // namespace gradmesh
