#pragma once

#include "simplify/simplify.h"

namespace gradmesh {

/// Returns the target that the options have for this mesh; nothing if they have none. Throws
/// std::invalid_argument if the target is out of range, if there are two targets, or if the method
/// cannot have one.
std::optional<Target> target_of(const SimplifyOptions& options, const Mesh& mesh);

/// Simplifies until the mesh reaches the target, with as small an error as the method finds: with
/// one epsilon after another, which is doubled or halved until one value is large enough and half
/// of that value is too small, then the interval between the two is narrowed down. Takes the mesh
/// with the fewest if no epsilon reaches the target. The time budget counts for the whole search.
SimplifyResult simplify_to_target(Mesh& mesh, const RunOptions& options, const Target& target);

}  // namespace gradmesh
