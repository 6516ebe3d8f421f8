#pragma once

#include <cstdint>
#include <vector>

#include "mesh/mesh.h"

namespace gradmesh {

/// Returns all inner edges in an order drawn from `seed` (paper 6.1, "random").
std::vector<Halfedge> random_order(const Mesh& mesh, std::uint64_t seed);

}  // namespace gradmesh
