#pragma once

#include "geom/cubic.h"
#include "mesh/mesh.h"
#include "ops/merge/merge_end.h"

namespace gradmesh {

/// Keeps 1/r and 1/(1-r) in Eq. 5 within reason.
inline constexpr double smallest_share = 1e-3;

/// Length of a curve in mesh units, to about a percent.
double length(const Cubic<Value>& curve);

/// The share of `in` in the length of two curves; a half where both have none.
double share_by_length(const Cubic<Value>& in, const Cubic<Value>& out);

/// split_factor of an edge whose ends are known already.
double split_factor(const Mesh& mesh, Halfedge edge, const MergeEnd& tail, const MergeEnd& head);

/// Where the merge takes the curves at one end of the edge to be split, as the share of `end.in`:
/// at a T-junction where that is; otherwise at `r` (Eq. 4) or, where the curves are changed less
/// so, at another place. Eq. 4 supposes that the tangents on both sides of the edge are those of
/// one smooth curve. Where they are not it can be far off, and Eq. 5 then makes handles many times
/// too long; and both ends of an edge need not agree.
double split_share(const Mesh& mesh, const MergeEnd& end, double r);

}  // namespace gradmesh
