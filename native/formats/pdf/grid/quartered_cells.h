#pragma once

#include <vector>

#include "formats/pdf/shading/read_patches.h"

namespace gradmesh {

/// Returns patches, of which four triangles that follow one another around a point in their middle
/// are four patches that meet there, with the middles of the cell's sides as corners: a grid that
/// keeps the colour of each point. A triangle is a patch with straight sides of which side 2 is
/// one point. Colours of the patches are bilinear, and so differ from those of the triangles.
std::vector<ShadingPatch> quartered_cells(const std::vector<ShadingPatch>& patches);

}  // namespace gradmesh
