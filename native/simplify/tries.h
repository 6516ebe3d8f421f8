#pragma once

#include <string>

#include "simplify/simplify.h"

namespace gradmesh {

/// Returns the method that is used where a person asks for `asked`, a method or `simplest`: of a
/// smooth mesh `lines`, unless the method that is asked for says why not. `simplest` is
/// `plain_method` if the mesh is one mesh gradient and handles are made few, and else
/// `best_method`.
const Method& method_for(const std::string& asked, const Mesh& mesh, Count count,
                         bool is_one_gradient);

/// Makes the mesh of the problem simpler by whatever serves best where a person asks for `asked`:
/// by method_for(), and where that leaves something to be wished by the methods that come next in a
/// list. An object that is one mesh gradient (Problem::gradient_rules) is not made a group of
/// blocks for little. Throws as simplify() does for the first method.
SimplifyResult simplify_as_asked(const Problem& problem, const std::string& asked,
                                 StopWatch& watch);

}  // namespace gradmesh
