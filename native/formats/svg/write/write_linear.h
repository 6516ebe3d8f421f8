#pragma once

#include "form/linear_colors.h"
#include "formats/svg/read/document.h"
#include "formats/svg/read/objects.h"

namespace gradmesh {

/// Gives an object that a mesh gradient paints these colours instead, in its user space: one colour
/// or a linear gradient. The object stays as it is otherwise. The mesh gradient is removed if
/// nothing else uses it.
void write_linear(SvgDocument& document, const MeshObject& object, const LinearColors& colors);

}  // namespace gradmesh
