#pragma once

#include <vector>

#include "formats/pdf/grid/page_patch.h"
#include "mesh/parts.h"

namespace gradmesh {

/// Joins loose patches, of any listing, to the parts of one mesh. Sides are one curve where all
/// their points are, within `tolerance`, and those of a side that others divide, one after the
/// other, where these are parts of it: T-junctions, at any place of the side. What lies beside
/// nothing else, or would fold over it, is on the boundary. Patches keep their order; those whose
/// corners lie counterclockwise (y down) are listed the other way around.
MeshParts page_mesh(const std::vector<PagePatch>& patches, double tolerance);

}  // namespace gradmesh
