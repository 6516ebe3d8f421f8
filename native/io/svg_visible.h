#pragma once

#include <optional>

#include "geom/outline.h"
#include "io/svg_document.h"
#include "io/svg_objects.h"

namespace gradmesh {

/// What the object shows of its mesh, in its user space: the inside of its own shape or, of a group
/// of blocks, of the shape that clips the group. Nothing where that is not known here: strokes and
/// text. Throws InputError at geometry that cannot be read.
std::optional<VisibleArea> visible_area(const SvgDocument& document, const MeshObject& object);

}  // namespace gradmesh
