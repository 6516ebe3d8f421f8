#pragma once

#include <libxml/tree.h>

#include <optional>

#include "formats/svg/values/path.h"

namespace gradmesh {

/// Bounding box of a shape's geometry in its user space, without stroke: path, rect, circle,
/// ellipse, line, polyline, polygon. Nothing for text and all else, whose size is not known here.
/// Throws InputError at attributes that cannot be read.
std::optional<Box> shape_box(const xmlNode* shape);

/// The outline of the shape's geometry, likewise; lines have none.
std::optional<Outline> shape_outline(const xmlNode* shape);

}  // namespace gradmesh
