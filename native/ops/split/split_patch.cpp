#include "ops/split/split_patch.h"

#include "ops/split/split.h"

namespace gradmesh {

void split_patch(Journal& journal, Face face, std::optional<double> row,
                 std::optional<double> column) {
  const Mesh& mesh = journal.mesh();
  if (!row) {
    if (column) split(journal, mesh.sides(face)[0], *column);
    return;
  }
  // The new edge is the bottom of what lies above it.
  const Halfedge bottom = split(journal, mesh.sides(face)[1], *row);
  if (!column) return;
  const Halfedge below = mesh[bottom].twin;
  split(journal, mesh.next(mesh.next(bottom)), *column);
  split(journal, below, *column);
}

}  // namespace gradmesh
