#pragma once

#include <libxml/tree.h>

#include <vector>

#include "geom/patch.h"
#include "io/svg_document.h"
#include "io/svg_objects.h"
#include "mesh/parts.h"

namespace gradmesh {

/// Patches of a rectangular mesh, row by row, `rows * columns` of them, both at least 1. Colours
/// are bilinear in each patch.
struct MeshGrid {
  int rows = 0, columns = 0;
  std::vector<Patch> patches;
};

/// The patches of a <meshgradient> in its own coordinates (of x, y and the paths, before
/// gradientTransform). As in Inkscape 1.2 the element that `href` leads to gives only its rows and
/// gradientUnits; x, y, type and gradientTransform are the element's own (SVG 2 would inherit
/// them). Throws InputError at all that Inkscape could not paint, and at type="bicubic".
MeshGrid read_mesh_gradient(const SvgDocument& document, const xmlNode* gradient);

/// The object's mesh in its user space: gradientTransform and gradientUnits applied. Throws
/// InputError as above, and where the units are the object's bounding box and that is not known or
/// without width or height.
MeshParts read_mesh(const SvgDocument& document, const MeshObject& object);

}  // namespace gradmesh
