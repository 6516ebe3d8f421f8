#pragma once

#include "methods/plain/plain_grid.h"
#include "methods/plain/steps.h"

namespace gradmesh {

/// A corner of a line that was smooth is seen from about here: the sine of its angle times the
/// difference of colour to the lines beside it. No metric tells such corners: a mean is small where
/// an artist sees an eyelid become angular.
inline constexpr double seen_corner = 0.15;

/// Returns how much is seen of the most visible corner between two straight sides of a line that
/// was smooth, as of seen_corner; 0 if there is none.
double largest_corner(const PlainGrid& grid);

/// Returns true if a line that was smooth would have a corner that is seen at one end of the side
/// if the side became straight. There is none where the other side stays a curve, which then
/// follows.
bool makes_corner(const PlainGrid& grid, const Side& side);

}  // namespace gradmesh
