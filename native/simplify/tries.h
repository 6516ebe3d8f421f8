#pragma once

#include <string>

#include "simplify/simplify.h"

namespace gradmesh {

/// Makes the mesh of the problem simpler by whatever serves best where a person asks for `asked`, a
/// method or `simplest`, and where that leaves something to be wished by the methods that come next
/// in a list. A smooth mesh is simplified by `lines`, unless the method that is asked for says why
/// not. `simplest` begins with `plain` if the mesh is one mesh gradient and handles are made few,
/// and is `best` otherwise. An object that is one mesh gradient (Problem::gradient_rules) is not
/// made a group of blocks for little. Throws as simplify() does for the first method.
SimplifyResult simplify_as_asked(const Problem& problem, const std::string& asked,
                                 StopWatch& watch);

}  // namespace gradmesh
