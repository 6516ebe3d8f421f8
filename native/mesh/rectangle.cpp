#include "mesh/rectangle.h"

#include <algorithm>

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

Halfedge side_from(const Mesh& mesh, Halfedge top, int side) {
  for (; side > 0; --side) top = mesh.next(top);
  return top;
}

Patch patch_from(const Mesh& mesh, Halfedge top) {
  const Face face = mesh.face(top);
  const Patch patch = mesh.patch(face);
  const std::array<Halfedge, 4> own = mesh.sides(face);
  const int first = int(std::ranges::find(own, top) - own.begin());
  if (first == 0) return patch;
  std::array<Cubic<Value>, 4> sides;
  std::array<Value, 4> twists;
  for (int k = 0; k < 4; ++k) {
    sides[k] = patch.side((first + k) % 4);
    twists[k] = patch.twist((first + k) % 4);
  }
  return patch_from_sides(sides, twists);
}

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
