#pragma once

#include "trace/evenness.h"
#include "trace/line_grid.h"
#include "trace/target_picture.h"

namespace gradmesh {

/// How long a fit goes on.
struct FitLength {
  int steps;
  /// A step that lowers the sum of the squares by less than this share of it is the last.
  double little;
  /// A fit ends when no step helps that is damped by as much as this, in squares of levels a square
  /// of a pixel: springs that are strong need more.
  double most_damping = 1e3;
};

/// Gives the points of a grid the colours with which its picture is closest to the target. Returns
/// the sum of the squares that is left.
double fit_colors(LineGrid& grid, const TargetPicture& target);

/// Moves the points of a grid and changes their colours, in steps of Gauss-Newton, so that the
/// grid's picture comes close to the target (patch_squares) and its lines stay even, as much as
/// suits the squares that it begins with (Evenness::for_patches). No patch folds that did not.
/// Returns the sum of the squares of the picture that is left.
double fit_lines(LineGrid& grid, const TargetPicture& target, const Evenness& evenness,
                 FitLength length);

/// Returns the sum of patch_squares over the grid.
double squares_of(const LineGrid& grid, const TargetPicture& target);

}  // namespace gradmesh
