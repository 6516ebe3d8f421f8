#pragma once

#include <cstdint>
#include <vector>

#include "mesh/mesh.h"

namespace gradmesh {

/// Returns all edges in the order of the grid method (paper 6.1, Fig. 7a): from a corner of the
/// mesh, row by row, the edges between the faces of a row; then the edges between the rows, column
/// by column. Corner and first direction follow `seed`. Parts of the mesh that the walk does not
/// reach (other components, faces behind T-junctions) follow with corners of their own, and each
/// edge comes once.
std::vector<Halfedge> grid_order(const Mesh& mesh, std::uint64_t seed);

/// Returns all edges in the order of the dual-grid method (Fig. 7b): the rows are those of the dual
/// mesh, so that the edges that lie on one line come one after another.
std::vector<Halfedge> dual_grid_order(const Mesh& mesh, std::uint64_t seed);

}  // namespace gradmesh
