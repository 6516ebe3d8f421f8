#pragma once

#include <vector>

#include "mesh/mesh.h"

namespace gradmesh {

/// Returns the mesh without these faces, of which there are fewer than all: their sides are its
/// boundary. Where only a part of a longer side is left without a neighbour, the face of that side
/// is split at the ends of the part, as split() does. Faces keep their order, the parts of a split
/// face among them in its place.
Mesh without_faces(Mesh mesh, const std::vector<Face>& faces);

}  // namespace gradmesh
