#pragma once

#include <optional>

#include "form/blocks.h"
#include "mesh/mesh.h"

namespace gradmesh {

/// How a mesh is written, and what readers will see of it. A run measures the surface, and the
/// writer writes the mesh in just this form.
struct WrittenForm {
  /// The mesh as a reader will find it.
  Mesh surface = {};
  /// The blocks of the group that the mesh becomes; if there are none, the mesh is written as a
  /// whole, in SVG as one mesh gradient.
  std::optional<BlockForm> blocks = std::nullopt;

  /// Returns the number of objects that paint the mesh.
  int object_count() const { return blocks ? int(blocks->blocks.size()) : 1; }
  bool masks_opacity() const { return blocks && blocks->masks_opacity; }
};

}  // namespace gradmesh
