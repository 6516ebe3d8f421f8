#include "mesh/rectangle.h"

#include "mesh/region.h"

namespace gradmesh {
namespace {

bool on_boundary(const Mesh& mesh, Halfedge leaf) { return !mesh.other_side(leaf).valid(); }

/// Returns the number of patches from `side` of a patch straight on to the boundary, or to a place
/// where the mesh is no grid. Returns more than the mesh has patches where there is no end.
int count_across(const Mesh& mesh, Halfedge side) {
  int count = 1;
  while (count <= mesh.face_count() && (side = leaf_across(mesh, side)).valid()) {
    side = mesh.next(mesh.next(side));
    ++count;
  }
  return count;
}

}  // namespace

std::optional<Rectangle> grid_from(const Mesh& mesh, Face face, int top) {
  const Halfedge first = mesh.sides(face)[top];
  const int columns = count_across(mesh, mesh.next(first));
  const int rows = count_across(mesh, mesh.next(mesh.next(first)));
  if (rows > mesh.face_count() || rows * columns != mesh.face_count()) return std::nullopt;
  Rectangle grid{rows, columns, region_tops(mesh, {face, top, rows, columns})};
  if (grid.tops.empty()) return std::nullopt;
  int boundary = 0;
  for (const Halfedge side : grid.tops)
    for (const Halfedge h : mesh.sides(mesh.face(side))) boundary += on_boundary(mesh, h);
  // All that lies inside has another patch across, so that what is left must be all around.
  if (boundary != 2 * (rows + columns)) return std::nullopt;
  return grid;
}

std::optional<Rectangle> find_grid(const Mesh& mesh) {
  for (int top = 0; top < 4; ++top)
    for (const Face f : mesh.faces()) {
      const std::array<Halfedge, 4> sides = mesh.sides(f);
      if (on_boundary(mesh, sides[top]) && on_boundary(mesh, sides[(top + 3) % 4]))
        return grid_from(mesh, f, top);
    }
  return std::nullopt;
}

}  // namespace gradmesh
