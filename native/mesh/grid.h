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

/// Returns the whole mesh as a grid: nothing but whole edges and regular points inside, and all
/// around it the boundary. Returns nothing for meshes with T-junctions, holes, branches or several
/// parts, and for rings. Rows and columns are counted as the patches themselves have them, if they
/// agree; a mesh that is read row by row starts at the same corner before and after patches of it
/// are merged.
std::optional<Grid> find_grid(const Mesh& mesh);

/// Returns the whole mesh as such a grid, whose first patch is `face` with its side `top` as its
/// top.
std::optional<Grid> grid_from(const Mesh& mesh, Face face, int top);

}  // namespace gradmesh
