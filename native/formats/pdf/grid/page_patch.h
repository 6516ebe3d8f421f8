#pragma once

#include <glm/vec4.hpp>

#include "formats/pdf/shading/patch_around.h"
#include "geom/patch.h"

namespace gradmesh {

/// A patch of a page: in page coordinates, with the colours of its corners as Value has them.
using PagePatch = PatchAround<glm::dvec4>;

/// Returns the patch with the same control points and sides, its colours bilinear.
Patch mesh_patch(const PagePatch& page);

/// Gives a patch the inner points that all patches of Illustrator and InDesign have: with them its
/// mixed derivatives at the corners are 0.
void set_zero_twist(PagePatch& patch);

}  // namespace gradmesh
