#pragma once

#include "base/progress.h"
#include "problem/problem.h"

namespace gradmesh {

/// Takes whole grid lines out of a mesh that is one rectangle of patches (find_grid), so that the
/// mesh stays one: the line that costs least first, as long as the whole error stays within
/// epsilon. After each line the prices of the others change; the cheapest is priced anew until the
/// cheapest line has its price in the mesh as it then is. A line whose removal would exceed epsilon
/// stays for good. The curves that cross a line are each split where they change least
/// (split_share): one place for all of them has left as many patches or more on every sample.
/// Throws InputError if the mesh is no such grid.
Candidate take_out_lines(const Problem& problem, StopWatch& watch);

}  // namespace gradmesh
