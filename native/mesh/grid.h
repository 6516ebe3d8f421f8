#pragma once

#include <optional>
#include <vector>

#include "mesh/mesh.h"

namespace gradmesh {

/// A mesh seen as one rectangle of patches.
struct Grid {
  int rows = 0, columns = 0;
  /// The top sides of the patches, row by row.
  std::vector<Halfedge> tops;

  Halfedge top(int row, int column) const { return tops[row * columns + column]; }
};

/// The whole mesh as a grid, where it is one: nothing but whole edges and regular points inside,
/// and all around it the boundary. Nothing for meshes with T-junctions, holes, branches or several
/// parts, and for rings. Rows and columns are counted as the patches themselves have them, if they
/// agree; a mesh read row by row and all that is left of it starts at the same corner.
std::optional<Grid> find_grid(const Mesh& mesh);

/// The same with the side `top` of the patch `face` as the top of its first patch.
std::optional<Grid> grid_from(const Mesh& mesh, Face face, int top);

}  // namespace gradmesh
