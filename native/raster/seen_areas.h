#pragma once

#include <vector>

#include "geom/flat_area.h"
#include "raster/frame.h"

namespace gradmesh {

/// Returns for each pixel of the frame, row by row, the index of the last area that covers its
/// centre, or -1. The areas are in the frame's mesh units.
std::vector<int> seen_areas(const std::vector<FlatArea>& areas, const Frame& frame);

}  // namespace gradmesh
