#pragma once

#include <vector>

#include "base/image.h"
#include "methods/plain/plain_grid.h"
#include "methods/plain/steps.h"
#include "raster/frame.h"

namespace gradmesh {

/// Returns which of the sides that became straight in a grid harm details: those along which the
/// errors of details (metric/detail_errors.h) are above the bound, and of all the closest to where
/// the error is largest. None if no side is near that.
std::vector<Side> harmful_sides(const std::vector<Side>& sides, const PlainGrid& grid,
                                const Plane& errors, double bound, const Frame& frame);

}  // namespace gradmesh
