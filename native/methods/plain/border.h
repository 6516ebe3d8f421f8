#pragma once

#include "methods/plain/plain_grid.h"
#include "reference/reference.h"

namespace gradmesh {

/// The distance in pixels from which a gap between the border of a mesh and where it was is seen.
inline constexpr double seen_gap = 1;

/// Returns how far the border of a grid is from the outlines of the original, in pixels, where it
/// is not hidden: at most a little more than Reference::outline_near looks. An error over all of
/// the picture does not tell such a gap at the edge of an object, which is a few pixels.
double border_gap(const PlainGrid& grid, const Reference& picture);

}  // namespace gradmesh
