#pragma once

#include "io/svg_document.h"
#include "io/svg_objects.h"

namespace gradmesh {

/// Puts in the place of a group of blocks the object that it stands for, with all that write_mesh
/// had moved to the group: shape, id, transform, opacity, effects, and what else it paints. Its
/// mesh paint names an empty mesh gradient (userSpaceOnUse) that waits for its patches. The group,
/// its blocks and what only they used are removed. Throws InputError where the shape is gone.
MeshObject restore_shape(SvgDocument& document, const MeshObject& group);

}  // namespace gradmesh
