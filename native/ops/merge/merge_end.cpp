#include "ops/merge/merge_end.h"

namespace gradmesh {

MergeEnd merge_end(const Mesh& mesh, Halfedge edge) {
  MergeEnd end{MergeEnd::branch, mesh.prev(edge), mesh.next(mesh[edge].twin), {}};
  if (mesh.is_stem(edge)) {
    end.kind = MergeEnd::stem;
    return end;
  }
  const Halfedge in_twin = mesh.other_side(end.in), out_twin = mesh.other_side(end.out);
  if (!in_twin.valid() && !out_twin.valid()) {
    end.kind = MergeEnd::boundary;
  } else if (in_twin.valid() && out_twin.valid()) {
    // Regular only where exactly one curve starts between the two on the other side.
    const Halfedge across = mesh.curve_side(mesh.next(mesh.last_leaf(out_twin)));
    const Halfedge back = mesh.curve_side(mesh.prev(mesh.first_leaf(in_twin)));
    if (mesh[across].twin == back && across != in_twin) {
      end.kind = MergeEnd::interior;
      end.across = across;
    }
  }
  return end;
}

}  // namespace gradmesh
