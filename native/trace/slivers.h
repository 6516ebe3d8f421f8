#pragma once

#include <vector>

#include "trace/equations.h"

namespace gradmesh {

/// What keeps patches from becoming slivers: thinner than a pixel, or with a corner that is nearly
/// 0 or 180 degrees. A fit finds that these are closer to the picture, as colours may jump there,
/// but what is painted of them is dots, scratches and dashes along a line.
///
/// Returns, for each patch row by row, the equations of squares that are 0 where it is 1.2 pixels
/// wide and has no corner sharper than 7 degrees or flatter than 173, and grow beyond that: up to
/// `weight` for each side across which it has no width, and for each corner without an area.
std::vector<NormalEquations> sliver_equations(const LineGrid& grid, const TargetPicture& target,
                                              const GridColumns& columns, double weight);

/// Returns the sum of these squares alone.
double sliver_squares(const LineGrid& grid, const TargetPicture& target, double weight);

}  // namespace gradmesh
