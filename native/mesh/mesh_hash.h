#pragma once

#include "base/hash.h"
#include "mesh/mesh.h"

namespace gradmesh {

/// Adds to the hash all that meshes differ in: their patches, how these are connected, and what is
/// fixed.
void add(Hash& hash, const Mesh& mesh);

}  // namespace gradmesh
