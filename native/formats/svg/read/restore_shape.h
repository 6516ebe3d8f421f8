#pragma once

#include "formats/svg/read/document.h"
#include "formats/svg/read/objects.h"

namespace gradmesh {

/// Throws InputError where restore_shape cannot: the shape is gone, or the object's fill and stroke
/// are both groups of blocks.
void check_restorable(SvgDocument& document, const MeshObject& group);

/// Puts in the place of a group of blocks the object that it stands for, with all that write_mesh
/// had moved to the group: shape, id, transform, opacity, effects, and what else it paints. Its
/// mesh paint names an empty mesh gradient (userSpaceOnUse) that waits for its patches. The group,
/// its blocks and what only they used are removed. Throws as check_restorable does, before anything
/// is changed.
MeshObject restore_shape(SvgDocument& document, const MeshObject& group);

}  // namespace gradmesh
