#include "methods/merging/manual.h"

#include "base/error.h"
#include "ops/merge/merge.h"

namespace gradmesh {

void merge_named_edges(MergeTrial& trial, const std::vector<int>& edges) {
  const Mesh& mesh = trial.mesh();
  for (const int number : edges) {
    if (number < 0 || number >= int(mesh.halfedge_slots()))
      throw InputError("there is no half-edge {0}.", number);
    const Halfedge edge{number};
    if (!mesh[edge].alive)
      throw InputError("half-edge {0} is gone after the merges before it.", number);
    const MergeObstacle obstacle = can_merge(mesh, edge);
    if (obstacle != MergeObstacle::none)
      throw InputError("half-edge {0} cannot be merged: {1}.", number, describe(obstacle));
    if (!trial.try_edge(edge))
      throw trial.measure().local_bound()
          ? InputError(
                "merging half-edge {0} makes the error larger than epsilon, or than the bound in "
                "a small part.",
                number)
          : InputError("merging half-edge {0} makes the error larger than epsilon.", number);
  }
}

}  // namespace gradmesh
