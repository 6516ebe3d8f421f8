#pragma once

#include "formats/svg/read/document.h"
#include "formats/svg/read/objects.h"

namespace gradmesh {

/// Puts a hidden copy of the object directly below it, with an id of its own that begins with the
/// object's, and marked as `kept-for` the object (formats/svg/read/read_group.h). Adds none if
/// there is a copy already.
void keep_hidden_copy(SvgDocument& document, const MeshObject& object);

}  // namespace gradmesh
