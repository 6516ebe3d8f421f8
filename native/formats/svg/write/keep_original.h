#pragma once

#include "formats/svg/read/document.h"
#include "formats/svg/read/objects.h"

namespace gradmesh {

/// Puts a copy of the object as it is directly below it, hidden, with an id of its own that begins
/// with the object's, and marked as `kept-for` the object (formats/svg/read/read_group.h). One that
/// is there already stays the only one.
void keep_hidden_copy(SvgDocument& document, const MeshObject& object);

}  // namespace gradmesh
