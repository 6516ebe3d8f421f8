#pragma once

#include <libxml/tree.h>

#include <optional>

#include "formats/svg/values/path.h"

namespace gradmesh {

/// Returns the bounding box of a shape's geometry in its user space, without stroke: path, rect,
/// circle, ellipse, line, polyline, polygon. Returns nothing for text and all other elements, whose
/// size is not known here. Throws InputError at attributes that cannot be read.
std::optional<Box> shape_box(const xmlNode* shape);

/// Returns the outline of the shape's geometry, if shape_box() returns a box; lines have none.
std::optional<Outline> shape_outline(const xmlNode* shape);

}  // namespace gradmesh
