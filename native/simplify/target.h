#pragma once

#include <optional>

#include "methods/method.h"
#include "simplify/options.h"

namespace gradmesh {

/// Returns what is made few: what the target is a number of, what `options.count` says, what the
/// method that is named makes few, and `otherwise` for `simplest`. Throws std::invalid_argument if
/// the options contradict each other.
Count what_is_counted(const SimplifyOptions& options, Count otherwise = Count::patches);

/// Returns the target that the options have for this mesh; nothing if they have none. Throws
/// std::invalid_argument if the target is out of range, if there are two targets, or if the method
/// cannot have one.
std::optional<Target> target_of(const SimplifyOptions& options, const Mesh& mesh);

/// Runs the method until the mesh reaches Bounds::target, with as small an error as the method
/// finds: with one epsilon after another, which is doubled or halved until one value is large
/// enough and half of that value is too small, then the interval between the two is narrowed down.
/// Returns the mesh with the fewest if no epsilon reaches the target.
Candidate search_for_target(const Problem& problem, const Method& method, StopWatch& watch);

}  // namespace gradmesh
