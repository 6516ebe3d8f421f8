#pragma once

#include "mesh/mesh.h"

namespace gradmesh {

/// One end p of an edge that is to be merged (paper 4.3, Fig. 4): the tail of `edge`, or the head
/// of the edge whose twin is `edge`.
struct MergeEnd {
  enum Kind {
    /// The edge is a stem at p: the T-junction p is removed (Fig. 4b).
    stem,
    /// p lies on the boundary and only two faces meet there: p is removed.
    boundary,
    /// p becomes a T-junction on the combined curve (Fig. 4a and c).
    interior,
    /// p must stay (4.4).
    branch,
  };
  Kind kind;
  /// The leaves along the side of the merged face: `in` ends at p, `out` starts there. `in`
  /// belongs to the face of `edge` (e_l and e_r of the paper).
  Halfedge in, out;
  /// For `interior`: the curve that starts at p on the other side and becomes a stem.
  Halfedge across;
};

MergeEnd merge_end(const Mesh& mesh, Halfedge edge);

}  // namespace gradmesh
