#pragma once

#include <vector>

#include "formats/pdf/shading/read_patches.h"

namespace gradmesh {

/// Returns patches, of which triangles that follow one another and share a side, with its colours,
/// are one with straight sides: what a plot divides for the sake of the format. A triangle is a
/// patch with straight sides of which side 2 is one point. Colours of the patch are bilinear, and
/// so differ from those of the triangles where these bend.
std::vector<ShadingPatch> paired_triangles(const std::vector<ShadingPatch>& patches);

}  // namespace gradmesh
