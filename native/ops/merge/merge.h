#pragma once

#include "base/message.h"
#include "ops/journal.h"

namespace gradmesh {

/// Why an edge cannot be merged: the five conditions of the paper's 4.2, and rings.
enum class MergeObstacle {
  none,
  boundary,      ///< 1: it has no twin
  parent,        ///< 2: it or its twin is divided by a T-junction
  bar,           ///< 3: it is a part of a longer curve
  next_cycle,    ///< 4: after the merge a curve would end on itself (4.4)
  origin_cycle,  ///< 4: after the merge a curve would start on itself (4.4)
  branch,        ///< 5: it meets a point that must stay (L- and U-branches; irregular points)
  ring,          ///< the two patches are one, or meet themselves round a ring
  fixed,         ///< a patch beside it, or beside a curve that would change, must stay as it is
};

/// Returns the obstacle as one clause for the person, such as "it is on the boundary of the mesh".
Message describe(MergeObstacle obstacle);

/// Returns why the two patches beside an edge cannot become one, or `none` if they can. `edge` is
/// any half-edge that is alive.
MergeObstacle can_merge(const Mesh& mesh, Halfedge edge);

/// Makes one patch of the two beside `edge` (Eq. 5, A.2) and mends the T-junctions at both of its
/// ends (4.3), as one operation of the journal. The face of `edge` is kept; that of the twin is
/// removed. `can_merge` must be `none`.
void merge(Journal& journal, Halfedge edge);

}  // namespace gradmesh
