#pragma once

#include <libxml/tree.h>

#include <map>
#include <string>
#include <vector>

#include "formats/svg/gradient/color_texts.h"
#include "formats/svg/tree/objects.h"
#include "formats/svg/tree/svg_tree.h"
#include "mesh/mesh.h"
#include "mesh/parts.h"

namespace gradmesh {

/// Returns the patches of a <meshgradient> in its own coordinates (of x, y and the paths, before
/// gradientTransform), with bilinear colours whatever its type is. As in Inkscape 1.2 the element
/// that `href` leads to gives only its rows and gradientUnits; x, y, type and gradientTransform are
/// the element's own (SVG 2 would inherit them). Throws InputError at all that Inkscape could not
/// paint.
PatchGrid gradient_patches(const SvgTree& tree, const xmlNode* gradient);
/// Returns gradient_patches(), and throws InputError at type="bicubic" too.
PatchGrid read_mesh_gradient(const SvgTree& tree, const xmlNode* gradient);

/// Returns the gradient whose rows a meshgradient has: itself, or one that its href leads to; null
/// if there is none.
const xmlNode* rows_holder(const SvgTree& tree, const xmlNode* gradient);

/// Returns the gradient and those that its href leads to, in this order.
std::vector<const xmlNode*> gradient_chain(const SvgTree& tree, const xmlNode* gradient);
/// Returns true if the gradient is placed by the bounding box of what it paints.
bool uses_bounding_box(const SvgTree& tree, const xmlNode* gradient);

/// Returns true if the meshgradient has smooth colours (type="bicubic").
bool is_smooth(const xmlNode* gradient);

/// Returns the object's mesh in its user space, with gradientTransform and gradientUnits applied. A
/// smooth mesh (type="bicubic") stays in the coordinates of its meshgradient, where Inkscape
/// measures the distances on which its colours depend. Throws InputError as read_mesh_gradient does
/// but for that type, and if the units are the object's bounding box and that is not known or has
/// no width or height.
MeshParts read_mesh(const SvgTree& tree, const MeshObject& object);
/// Returns the patches of read_mesh() in their rows and columns.
PatchGrid read_mesh_patches(const SvgTree& tree, const MeshObject& object);

/// Return the maps from the coordinates of the object's mesh to the object's user space, which is
/// the identity for a group of blocks, and to the coordinates of the object's meshgradient. Throw
/// as read_mesh does.
Affine mesh_to_user(const SvgTree& tree, const MeshObject& object);
Affine mesh_to_gradient(const SvgTree& tree, const MeshObject& object);
/// Returns the map from the gradient's coordinates to the object's user space. Throws as read_mesh
/// does.
Affine gradient_to_user(const SvgTree& tree, const MeshObject& object);

/// Returns the mesh gradients with rows that paint none of the objects, no block and no part of a
/// text, and that give their rows to no gradient that does. `objects` must be all objects of the
/// document.
std::vector<const xmlNode*> unused_mesh_gradients(const SvgTree& tree,
                                                  const std::vector<MeshObject>& objects);

/// A mesh gradient that paints nothing.
struct UnusedGradient {
  std::string id;
  int patches = 0;
};
/// Returns what unused_mesh_gradients() returns as values.
std::vector<UnusedGradient> unused_gradients(const SvgTree& tree,
                                             const std::vector<MeshObject>& objects);

/// Writes a mesh that is a grid, bilinear and with one colour at each point, into a meshgradient
/// without rows, in its gradient_form(). `to_gradient` maps the mesh to the gradient's coordinates.
/// Colours that are among `texts` are written as they stand there.
void write_grid(const SvgTree& tree, xmlNode* gradient, const Mesh& mesh, double coons_tolerance,
                const Affine& to_gradient, const ColorTexts& texts = {});

/// Lets another mesh gradient paint the object, as its own paint and with the colour for programs
/// that know no meshes.
void paint_by_gradient(const SvgTree& tree, const MeshObject& object, const xmlNode* gradient);

/// The gradients that were written, by the id of the one that each was made of.
using GradientsByOrigin = std::map<std::string, std::vector<xmlNode*>>;

/// Gives an object that a mesh gradient paints a new gradient, with fewer rows and columns: the
/// object is otherwise unchanged, and the new gradient has the old one's units, transform and type.
/// The old gradient is removed if nothing else uses it. The mesh is a grid (find_grid), bilinear,
/// in the coordinates of read_mesh, with one colour at each point, and is written in its
/// gradient_form(). Colours of `texts`, which are usually the object's color_texts(), are written
/// as they stood. The object's memory (formats/svg/gradient/written_gradient.h) is removed.
/// Objects that shared the old gradient share the new one where it is the same, if `by_origin` has
/// what was written before. Returns the object with its new gradient.
MeshObject write_mesh_gradient(SvgTree& tree, const MeshObject& object, const Mesh& mesh,
                               double coons_tolerance, const ColorTexts& texts,
                               GradientsByOrigin* by_origin = nullptr);
/// Does the same with the object's own color_texts().
MeshObject write_mesh_gradient(SvgTree& tree, const MeshObject& object, const Mesh& mesh,
                               double coons_tolerance, GradientsByOrigin* by_origin = nullptr);

}  // namespace gradmesh
