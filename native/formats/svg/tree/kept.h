#pragma once

#include "formats/svg/tree/objects.h"
#include "formats/svg/tree/svg_tree.h"

namespace gradmesh {

/// Puts a hidden copy of the object directly below it, with an id of its own that begins with the
/// object's, and marked as `kept-for` the object (formats/svg/tree/own.h). Adds none if
/// there is a copy already.
void keep_hidden_copy(SvgTree& tree, const MeshObject& object);

/// Removes all such copies.
void remove_hidden_originals(SvgTree& tree);

}  // namespace gradmesh
