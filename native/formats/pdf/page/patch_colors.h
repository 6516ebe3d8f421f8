#pragma once

#include <array>
#include <vector>

#include "formats/pdf/grid/page_patch.h"
#include "formats/pdf/page/read_shading.h"
#include "formats/pdf/shading/read_patches.h"

namespace gradmesh {

/// The opacities of a patch's corners, 0..1.
using CornerOpacities = std::array<double, 4>;

/// Returns patches with the colours of their corners in sRGB, opaque, each as it is: what lies
/// between its corners may have other colours than the shading.
std::vector<PagePatch> corners_in_srgb(const std::vector<ShadingPatch>& patches,
                                       const ShadingColors& colors);

/// Returns patches with their colours in sRGB, between whose corners is blended linearly, as a mesh
/// of SVG does. A PDF blends components, or the parameter of a function, so a patch is halved, at
/// most five times along each direction, until a lattice of 5 x 5 of its points is off by 4 levels
/// of 255 at most; its parts follow one another. The sides decide along which direction, so that
/// neighbours are mostly divided at the same places. What would make more parts than a mesh may
/// have patches stays as it is. Patches are opaque, or have `opacities`, one for each.
std::vector<PagePatch> in_srgb(const std::vector<ShadingPatch>& patches,
                               const ShadingColors& colors,
                               const std::vector<CornerOpacities>& opacities = {});

}  // namespace gradmesh
