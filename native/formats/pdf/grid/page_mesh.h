#pragma once

#include <vector>

#include "formats/pdf/grid/page_patch.h"
#include "mesh/parts.h"

namespace gradmesh {

/// Joins loose patches, of any listing, to the parts of one mesh, which build_mesh() takes. Sides
/// are one curve where all their points are, within `tolerance`, and where one or more on each side
/// of a line are the parts of one, within twice that: T-junctions, at any place of the curve. What
/// lies beside nothing else, or would fold over it, is on the boundary, and so is a line whose
/// T-junctions do not go together (sound_slits). Patches keep their order; those whose corners lie
/// counterclockwise (y down) are listed the other way around.
MeshParts page_mesh(const std::vector<PagePatch>& patches, double tolerance);

}  // namespace gradmesh
