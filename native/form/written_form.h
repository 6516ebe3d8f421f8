#pragma once

#include <optional>

#include "form/blocks.h"
#include "mesh/mesh.h"

namespace gradmesh {

/// How a mesh is written, and what readers will see of that. A run measures the surface, and the
/// writer writes the mesh in just this form.
struct WrittenForm {
  /// The mesh as a reader will find it.
  Mesh surface = {};
  /// The blocks of the group that it becomes; nothing: it is written as a whole, in SVG as one mesh
  /// gradient.
  std::optional<BlockForm> blocks = std::nullopt;
  /// How far an interior point may be from the Coons patch's without `tensor` being written, in
  /// the unit of the positions.
  double coons_tolerance = 0;

  bool masks_opacity() const { return blocks && blocks->masks_opacity; }
};

}  // namespace gradmesh
