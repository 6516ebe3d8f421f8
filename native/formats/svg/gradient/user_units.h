#pragma once

#include "formats/svg/tree/svg_tree.h"

namespace gradmesh {

/// Inkscape takes over what an extension returns by taking elements that differ out of the document
/// on its canvas and putting the new ones in. It asks for the box of a rectangle, an ellipse, a
/// star or a line before it has made its outline, so a mesh that is placed by that box
/// (objectBoundingBox) is painted nowhere until the document is opened again.

/// Writes the meshes of such shapes in user units, the box as part of the gradientTransform, where
/// a canvas that shows the document `shown` would put the shape or its gradient in anew. The meshes
/// stay where they are, and their rows as they are written. Returns false if nothing was changed.
bool use_user_units(SvgTree& tree, const SvgTree& shown);

}  // namespace gradmesh
