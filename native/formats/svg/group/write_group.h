#pragma once

#include <string>
#include <vector>

#include "form/blocks.h"
#include "form/counts.h"
#include "formats/svg/gradient/rows.h"
#include "formats/svg/tree/objects.h"
#include "mesh/mesh.h"

namespace gradmesh {

struct WrittenMesh {
  /// The mesh in the object's user space, colour model `bilinear`.
  const Mesh& mesh;
  const BlockForm& form;
  /// The label that the person sees where there is none of theirs, such as "Gradient mesh: 140 of
  /// 660 handles, ...".
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

/// Puts a simplified mesh in the place of the object: a group of blocks, as of replace_shape. An
/// object that is such a group already gets new blocks. Gradients that nothing uses any more are
/// removed. The object's node is replaced. Each point is rounded once and written in absolute
/// coordinates, so that blocks that share a point have the very same coordinates there and
/// Inkscape's mesh tool joins them.
void write_group(SvgTree& tree, const MeshObject& object, const WrittenMesh& written);

/// Removes the blocks of a group, the mask that holds their opacities if there is one, and the
/// gradients that nothing else uses. Returns the colour that programs without meshes paint instead
/// of the blocks; empty if there is none.
std::string remove_blocks(SvgTree& tree, xmlNode* group);

/// Adds a meshgradient in userSpaceOnUse that holds the block. Returns its id, which begins with
/// `prefix`.
std::string add_gradient(SvgTree& tree, const Mesh& mesh, const Rectangle& block,
                         const GradientFormat& format, const std::string& prefix);

}  // namespace gradmesh
