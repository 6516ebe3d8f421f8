#pragma once

#include <vector>

#include "app/document/svg_document.h"
#include "formats/code/mesh_code.h"

namespace gradmesh {

struct CodeOfMesh {
  /// Without a name.
  MeshCode code;
  /// What of the object's look it does not hold.
  std::vector<Message> lost;
};

/// Returns a mesh as programs with mesh gradients of their own hold it.
CodeOfMesh code_of_mesh(const SvgDocument& document, const MeshEntry& entry);

}  // namespace gradmesh
