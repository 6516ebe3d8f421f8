#pragma once

#include <vector>

#include "ops/journal.h"

namespace gradmesh {

/// Sets whether these patches must stay as they are (Mesh::is_fixed), as one operation of the
/// journal.
void set_fixed(Journal& journal, const std::vector<Face>& faces, bool is_fixed);

/// Returns the mesh with these patches fixed besides those that are.
Mesh with_fixed(Mesh mesh, const std::vector<Face>& faces);

/// Returns true if two meshes differ at most in which of their patches are fixed.
bool are_same_but_for_fixed(const Mesh& a, const Mesh& b);

}  // namespace gradmesh
