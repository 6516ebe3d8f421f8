#pragma once

#include "base/progress.h"
#include "problem/problem.h"

namespace gradmesh {

/// Takes handles out of a mesh that is one grid as long as it keeps to the bounds: sides are made
/// straight, many at once while they are cheap, and whole lines of points are taken out. What costs
/// least for each handle comes first, and all points are fitted to the picture after each step, so
/// that lines come to stand elsewhere than any did before. Ends where the target is reached.
/// Returns Problem::unchanged() if the grid without twists cannot be fitted so that it keeps to the
/// bounds, or if no handle can be taken out.
Candidate make_plain(const Problem& problem, StopWatch& watch);

}  // namespace gradmesh
