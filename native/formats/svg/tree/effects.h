#pragma once

#include "formats/svg/tree/objects.h"
#include "formats/svg/tree/svg_tree.h"

namespace gradmesh {

/// What happens to the painted mesh of an object, by the object itself and all around it, and what
/// the object shows beside the mesh.
struct ObjectEffects {
  /// The product of all opacities, 0..1.
  double opacity = 1;
  /// The number of clip paths.
  int clips = 0;
  /// Masks, without those that hold a mesh's own opacities or cut it to a stroke.
  int masks = 0;
  bool has_filter = false;
  bool has_blend_mode = false;
  /// True if the object has another paint as well: a stroke beside the fill, or the reverse.
  bool has_other_paint = false;
};

ObjectEffects object_effects(const SvgTree& tree, const MeshObject& object);

}  // namespace gradmesh
