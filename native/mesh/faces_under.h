#pragma once

#include <vector>

#include "geom/outline.h"
#include "mesh/mesh.h"

namespace gradmesh {

/// Returns the faces of which an area, in mesh units, covers something, in rising order. A strip
/// along a side of less than a thirtieth of the patch is nothing: an area drawn along the border of
/// one patch does not cover the next.
std::vector<Face> faces_under(const Mesh& mesh, const FilledOutline& area);

}  // namespace gradmesh
