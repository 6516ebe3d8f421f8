#pragma once

#include "ops/merge/merge_end.h"

namespace gradmesh {

/// Returns the place of p on the curve that the curves of `end.in` and `end.out` become (Eq. 6), if
/// r is the share of `in` in the length of `in` and `out`.
double combined_share(const Mesh& mesh, const MergeEnd& end, double r);

/// Returns the parameter r at which the two patches beside `edge` are taken to be split (Eq. 4), as
/// the share of the patch of `edge`: 0 < r < 1. Where Eq. 4 has nothing to divide, since tangents
/// vanish or point apart, r follows from the lengths of the curves instead. `tail` and `head` are
/// the ends of the edge.
double split_factor(const Mesh& mesh, Halfedge edge, const MergeEnd& tail, const MergeEnd& head);

/// Returns the share of `end.in` at which a merge takes the curves at one end of the edge to be
/// split: at a T-junction that of the bars; otherwise `r` (Eq. 4) or, where the curves are changed
/// less by it, another share. Eq. 4 supposes that the tangents on both sides of the edge are those
/// of one smooth curve. Where they are not, Eq. 4 can be far off, and Eq. 5 then makes handles many
/// times too long; and both ends of an edge need not agree.
double split_share(const Mesh& mesh, const MergeEnd& end, double r);

}  // namespace gradmesh
