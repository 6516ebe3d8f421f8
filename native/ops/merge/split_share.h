#pragma once

#include "geom/cubic.h"
#include "mesh/mesh.h"
#include "ops/merge/merge_end.h"

namespace gradmesh {

/// The smallest share, and the distance of the largest from 1, which keep 1/r and 1/(1-r) in Eq. 5
/// within reason.
inline constexpr double smallest_share = 1e-3;

/// Returns the length of a curve in mesh units, to about a percent.
double length(const Cubic<Value>& curve);

/// Returns the share of `in` in the length of two curves; a half where both have none.
double share_by_length(const Cubic<Value>& in, const Cubic<Value>& out);

/// Returns split_factor() of an edge whose ends are known already.
double split_factor(const Mesh& mesh, Halfedge edge, const MergeEnd& tail, const MergeEnd& head);

/// Returns the share of `end.in` at which a merge takes the curves at one end of the edge to be
/// split: at a T-junction that of the bars; otherwise `r` (Eq. 4) or, where the curves are changed
/// less by it, another share. Eq. 4 supposes that the tangents on both sides of the edge are those
/// of one smooth curve. Where they are not, Eq. 4 can be far off, and Eq. 5 then makes handles many
/// times too long; and both ends of an edge need not agree.
double split_share(const Mesh& mesh, const MergeEnd& end, double r);

}  // namespace gradmesh
