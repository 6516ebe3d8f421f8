#pragma once

#include <libxml/tree.h>

#include <vector>

#include "formats/svg/read/document.h"
#include "formats/svg/read/objects.h"
#include "geom/patch.h"
#include "mesh/parts.h"

namespace gradmesh {

/// The largest coordinate of a patch. It keeps the distances between its points, which are what a
/// document holds, within Scanner's limit.
inline constexpr double largest_reach = 5e8;

/// Returns true if no control point lies beyond largest_reach.
bool is_within_limits(const Patch& patch);

/// Returns the patches of a <meshgradient> in its own coordinates (of x, y and the paths, before
/// gradientTransform), with bilinear colours whatever its type is. As in Inkscape 1.2 the element
/// that `href` leads to gives only its rows and gradientUnits; x, y, type and gradientTransform are
/// the element's own (SVG 2 would inherit them). Throws InputError at all that Inkscape could not
/// paint.
PatchGrid gradient_patches(const SvgDocument& document, const xmlNode* gradient);
/// Does the same, and throws InputError at type="bicubic" too.
PatchGrid read_mesh_gradient(const SvgDocument& document, const xmlNode* gradient);

/// Returns true if the meshgradient has smooth colours (type="bicubic").
bool is_smooth(const xmlNode* gradient);

/// Returns the object's mesh in its user space, with gradientTransform and gradientUnits applied. A
/// smooth mesh (type="bicubic") stays in the coordinates of its meshgradient, where Inkscape
/// measures the distances on which its colours depend. Throws InputError as read_mesh_gradient does
/// but for that type, and if the units are the object's bounding box and that is not known or has
/// no width or height.
MeshParts read_mesh(const SvgDocument& document, const MeshObject& object);
/// Does the same, and returns the patches in their rows and columns.
PatchGrid read_mesh_patches(const SvgDocument& document, const MeshObject& object);

/// Return the maps from the coordinates of read_mesh to the object's user space, and to the
/// coordinates of its meshgradient. Throw as read_mesh does.
Affine mesh_to_user(const SvgDocument& document, const MeshObject& object);
Affine mesh_to_gradient(const SvgDocument& document, const MeshObject& object);

/// Returns the mesh gradients with rows that paint none of the objects, no block and no part of a
/// text, and that give their rows to no gradient that does. `objects` must be all objects of the
/// document.
std::vector<const xmlNode*> unused_mesh_gradients(const SvgDocument& document,
                                                  const std::vector<MeshObject>& objects);

/// Returns true if the meshgradient's units are its object's bounding box, by its own attribute or
/// by href.
bool in_bounding_box(const SvgDocument& document, const xmlNode* gradient);

}  // namespace gradmesh
