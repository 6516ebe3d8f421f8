#pragma once

#include <optional>
#include <vector>

#include "mesh/mesh.h"

namespace gradmesh {

/// The direction in which a side of a patch or a line of points of a grid runs.
enum class Along { rows, columns };

/// Patches in rows and columns, as a mesh gradient holds them: the whole of a mesh that is a grid,
/// or a part of any mesh.
struct Rectangle {
  int rows = 0, columns = 0;
  /// The half-edges along the patches' upper sides, row by row, each of its own patch.
  std::vector<Halfedge> tops;

  Halfedge top(int row, int column) const { return tops[row * columns + column]; }
};

/// Returns the whole mesh as a grid: nothing but whole edges and regular points inside, and all
/// around it the boundary. Returns nothing for meshes with T-junctions, holes, branches or several
/// parts, and for rings. Rows and columns are counted as the patches themselves have them, if they
/// agree; a mesh that is read row by row starts at the same corner before and after patches of it
/// are merged.
std::optional<Rectangle> find_grid(const Mesh& mesh);

/// Returns the whole mesh as such a grid, whose first patch is `face` with its side `top` as its
/// top.
std::optional<Rectangle> grid_from(const Mesh& mesh, Face face, int top);

}  // namespace gradmesh
