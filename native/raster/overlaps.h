#pragma once

#include <vector>

#include "mesh/elements.h"
#include "mesh/mesh.h"
#include "raster/frame.h"

namespace gradmesh {

/// Returns the overlaps of faces that are seen in the frame: at some pixel both faces are painted,
/// and no other face between them. In rising order.
std::vector<Overlap> find_overlaps(const Mesh& mesh, const Frame& frame);

}  // namespace gradmesh
