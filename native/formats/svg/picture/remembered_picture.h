#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "base/affine.h"
#include "formats/svg/tree/objects.h"
#include "formats/svg/tree/svg_tree.h"

namespace gradmesh {

/// The picture that a mesh was traced from, as the object with the mesh remembers it: in the
/// attribute `picture` of our own namespace, which has these members in this order.
struct RememberedPicture {
  /// A hash of the bytes of its file.
  std::uint64_t hash = 0;
  /// The map from pixels of the file to the coordinates of the mesh, when it was traced.
  Affine to_mesh = {};
  /// The id of the <image> that shows it.
  std::string image = {};
};

/// Returns the picture that an object remembers, if an <image> with that id is in the document;
/// nothing if it remembers none, or the attribute is damaged.
std::optional<RememberedPicture> remembered_picture(const SvgTree& tree, const MeshObject& object);

/// Lets an object remember the picture that its mesh was traced from, in place of another.
void remember_picture(const MeshObject& object, const RememberedPicture& picture);

}  // namespace gradmesh
