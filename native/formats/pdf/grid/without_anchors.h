#pragma once

#include <vector>

#include "formats/pdf/grid/page_patch.h"

namespace gradmesh {

/// Patches some of which were joined.
struct JoinedPatches {
  std::vector<PagePatch> patches;
  /// How far sides of joined patches are from those that they replace, at most.
  double distance = 0;
};

/// Takes back what Illustrator and InDesign do to patches with anchors on their sides: a line from
/// an anchor divides the patch, and ends on the other side of it where no anchor is. So lines that
/// end in a T-junction are no lines of the artist's grid, and all patches along them are joined, if
/// that makes one grid without T-junctions (page_grids); returns the patches as they are otherwise,
/// and where they are such a grid or more than 5000. A side with anchors may be more than one cubic
/// curve, so the joined side is only the closest, and is refused where that is far from them.
/// Joined patches have zero twist, as all of these programs have. `tolerance` is the largest by
/// which points of neighbours differ; smaller ones are tried too.
JoinedPatches without_anchors(const std::vector<PagePatch>& patches, double tolerance);

}  // namespace gradmesh
