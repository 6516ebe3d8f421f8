#pragma once

#include "simplify/simplify.h"

namespace gradmesh {

/// Returns the number of patches that the options ask for, of a mesh with `patches_before` patches;
/// nothing if the options have no target. Throws std::invalid_argument if the target is out of
/// range, if there are two targets, or if the method cannot have one.
std::optional<int> target_patches(const SimplifyOptions& options, int patches_before);

/// Merges patches until at most `patches` are left, with as small an error as the method finds.
/// Simplifies with one epsilon after another: epsilon is doubled or halved until one value is large
/// enough and half of that value is too small, then the interval between the two is narrowed down.
/// Takes the mesh with the fewest patches if no epsilon reaches the target. The time budget counts
/// for the whole search.
SimplifyResult simplify_to_target(Mesh& mesh, const RunOptions& options, int patches);

}  // namespace gradmesh
