#pragma once

#include <string>
#include <vector>

#include "formats/code/mesh_code.h"

namespace gradmesh {

/// Returns a file of Swift with a view of SwiftUI for each mesh, which paints it by MeshGradient
/// (iOS 18, macOS 15). `origin` is told in its first comment. Numbers are in flat typed arrays:
/// Swift's type checker takes long for large expressions of anything else.
std::string swift_code(const std::vector<MeshCode>& meshes, const std::string& origin);

}  // namespace gradmesh
