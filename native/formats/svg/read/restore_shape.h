#pragma once

#include "formats/svg/read/document.h"
#include "formats/svg/read/objects.h"

namespace gradmesh {

/// Throws InputError if restore_shape cannot work: the shape is gone, or the object's fill and
/// stroke are both groups of blocks.
void check_restorable(SvgDocument& document, const MeshObject& group);

/// Replaces a group of blocks by the object that it was made of, with all that write_mesh had moved
/// to the group: shape, id, transform, opacity, effects, and the other paint. The object's mesh
/// paint names an empty mesh gradient (userSpaceOnUse), whose patches the caller writes. The group,
/// its blocks and what only they used are removed. Throws as check_restorable does, before anything
/// is changed. Returns the object.
MeshObject restore_shape(SvgDocument& document, const MeshObject& group);

}  // namespace gradmesh
