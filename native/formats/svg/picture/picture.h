#pragma once

#include <string>

#include "base/affine.h"
#include "form/linear_colors.h"
#include "formats/svg/tree/objects.h"
#include "geom/box.h"

namespace gradmesh {

/// A picture that shows a mesh.
struct PlacedPng {
  /// A PNG file.
  std::string png;
  /// Where the picture lies, in the object's user space.
  Box place;
  /// The outline of the mesh as path data, which limits what is shown of the picture, and the map
  /// from its coordinates to the object's user space. Empty if the object's own shape limits it.
  std::string outline = {};
  Affine outline_to_user = {};
};

/// Shows the picture in the place of the object's mesh: of a mesh gradient as replace_shape does
/// it, of a group of blocks inside the group.
void write_picture(SvgTree& tree, const MeshObject& object, const PlacedPng& picture);

/// Gives an object that a mesh gradient paints these colours instead, in its user space: one colour
/// or a linear gradient. The object stays as it is otherwise. The mesh gradient is removed if
/// nothing else uses it.
void write_linear(SvgTree& tree, const MeshObject& object, const LinearColors& colors);

}  // namespace gradmesh
