#pragma once

#include <string>
#include <vector>

#include "form/blocks.h"
#include "form/counts.h"
#include "formats/svg/read/document.h"
#include "formats/svg/read/objects.h"
#include "mesh/mesh.h"

namespace gradmesh {

struct WrittenMesh {
  /// The mesh in the object's user space, colour model `bilinear`.
  const Mesh& mesh;
  const BlockForm& form;
  /// The label that the person sees, such as "Gradient mesh: 140 of 660 handles, ...".
  std::string label;
  /// The counts before the mesh was first simplified, as of counts_before.
  MeshCounts before;
  /// The mesh before it was first simplified, as of remember(), for the group to remember; empty if
  /// there is none.
  std::string original = {};
  /// True if the mesh has the faces of the group whose place it takes. Blocks of the same faces
  /// then keep the ids of their paths and gradients.
  bool keeps_faces = false;
};

/// Puts a simplified mesh in the place of the object: a group of blocks with the object's id,
/// transform, opacity, filter and place among its neighbours, clipped by the object's own shape or,
/// for a stroke, masked by the stroke in white (a clip path knows no strokes). The object's other
/// paint (its stroke, or its fill) is kept as an object beside the blocks. An object that is such a
/// group already gets new blocks. Gradients that nothing uses any more are removed. The object's
/// node is replaced.
void write_mesh(SvgDocument& document, const MeshObject& object, const WrittenMesh& written);

}  // namespace gradmesh
