#pragma once

#include "simplify/simplify.h"

namespace gradmesh {

/// How many patches the options ask for, of a mesh that has so many; nothing where they name an
/// error instead. Throws std::invalid_argument where they ask for nothing sensible, or twice.
std::optional<int> target_patches(const SimplifyOptions& options, int patches_before);

/// Merges patches until at most `patches` are left, with as small an error as the method finds:
/// simplifies to one epsilon after another, which is halved or doubled until it lies between two
/// of which one is large enough, and then narrowed down. Where no error is enough, the fewest
/// patches that were found. The time budget counts for all of it.
SimplifyResult simplify_to_target(Mesh& mesh, const RunOptions& options, int patches);

}  // namespace gradmesh
