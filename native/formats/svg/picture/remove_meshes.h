#pragma once

#include "formats/svg/tree/svg_tree.h"

namespace gradmesh {

/// Removes what a document without meshes does not need: mesh gradients that paint nothing, the
/// scripts by which Inkscape has browsers paint meshes, and all that is in our own namespace. Where
/// a mesh gradient that is removed is still named, which nobody sees, the colour for programs
/// without meshes takes its place, or none.
void remove_meshes(SvgTree& tree);

}  // namespace gradmesh
