#pragma once

#include <vector>

#include "formats/pdf/grid/patch_sides.h"

namespace gradmesh {

/// A rectangle of patches without T-junctions, row by row, with side 0 of each at its upper side.
struct PageGrid {
  int rows = 0, columns = 0;
  std::vector<LaidPatch> patches;
};

/// Joins loose patches to rectangles: each grows from the first patch that is left, first its row
/// and then whole rows below and above. Rows and columns are those of that patch; where its sides
/// run counterclockwise (y down), those of its mirror image.
std::vector<PageGrid> page_grids(const PatchSides& sides);

}  // namespace gradmesh
