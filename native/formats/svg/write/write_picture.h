#pragma once

#include <string>

#include "base/affine.h"
#include "formats/svg/read/document.h"
#include "formats/svg/read/objects.h"
#include "geom/box.h"

namespace gradmesh {

/// A picture that shows a mesh.
struct PlacedPicture {
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
void write_picture(SvgDocument& document, const MeshObject& object, const PlacedPicture& picture);

}  // namespace gradmesh
