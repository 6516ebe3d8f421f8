#pragma once

#include <string>
#include <vector>

#include "formats/code/mesh_code.h"

namespace gradmesh {

/// Returns a file of Kotlin with a composable for each mesh, which paints it by the
/// MeshGradientPainter of Jetpack Compose. `origin` is told in its first comment. Numbers are in
/// objects of a few thousand each: a method of Java has at most 64 KB, in which eight bytes put a
/// number into an array, and a class at most 65535 different ones.
std::string compose_code(const std::vector<MeshCode>& meshes, const std::string& origin);

}  // namespace gradmesh
