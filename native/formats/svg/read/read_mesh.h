#pragma once

#include <libxml/tree.h>

#include <vector>

#include "formats/svg/read/document.h"
#include "formats/svg/read/objects.h"
#include "geom/patch.h"
#include "mesh/parts.h"

namespace gradmesh {

/// Patches of a rectangular mesh, row by row, `rows * columns` of them, both at least 1. Colours
/// are bilinear in each patch.
struct MeshGrid {
  int rows = 0, columns = 0;
  std::vector<Patch> patches;
};

/// No coordinate of a patch is larger, so that the distances between its points, which are what a
/// document holds, are within Scanner's limit.
inline constexpr double largest_reach = 5e8;

/// Whether no control point lies beyond that.
bool is_within_limits(const Patch& patch);

/// The patches of a <meshgradient> in its own coordinates (of x, y and the paths, before
/// gradientTransform). As in Inkscape 1.2 the element that `href` leads to gives only its rows and
/// gradientUnits; x, y, type and gradientTransform are the element's own (SVG 2 would inherit
/// them). Throws InputError at all that Inkscape could not paint, and at type="bicubic".
MeshGrid read_mesh_gradient(const SvgDocument& document, const xmlNode* gradient);

/// The object's mesh: in its user space, gradientTransform and gradientUnits applied. A smooth mesh
/// (type="bicubic") stays in the coordinates of its meshgradient, where Inkscape measures the
/// distances on which its colours depend. Throws InputError as above but for that type, and where
/// the units are the object's bounding box and that is not known or without width or height.
MeshParts read_mesh(const SvgDocument& document, const MeshObject& object);

/// From the coordinates of read_mesh to the object's user space, and to those of its meshgradient.
/// Throw as read_mesh does.
Affine mesh_to_user(const SvgDocument& document, const MeshObject& object);
Affine mesh_to_gradient(const SvgDocument& document, const MeshObject& object);

/// The mesh gradients with rows that paint none of the objects, of which there are all, no block
/// and no part of a text, and give their rows to none that does.
std::vector<const xmlNode*> unused_mesh_gradients(const SvgDocument& document,
                                                  const std::vector<MeshObject>& objects);

/// Whether the meshgradient's units are its object's bounding box, as it says itself or by href.
bool in_bounding_box(const SvgDocument& document, const xmlNode* gradient);

}  // namespace gradmesh
