#pragma once

#include <functional>
#include <vector>

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

/// Called with each mesh that a run passes.
using MeshPassed = std::function<void(const Candidate&)>;

/// Passes from the mesh to ever plainer ones, under one pair of bounds after another, each at least
/// as wide as the one before: what costs little goes before what costs much, so that each mesh is
/// about what make_plain() makes under bounds to which it just keeps. Calls `is_through` with the
/// number of bounds within which nothing more can be taken out. Passes nothing under bounds to
/// which the grid without twists cannot be fitted.
void pass_plain(const Problem& problem, const std::vector<Bounds>& bounds, StopWatch& watch,
                const MeshPassed& passed, const std::function<void(std::size_t)>& is_through);

}  // namespace gradmesh
