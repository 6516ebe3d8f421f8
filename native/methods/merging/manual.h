#pragma once

#include <vector>

#include "trial/merge_trial.h"

namespace gradmesh {

/// Merges the edges of these half-edges in their order. Throws InputError if one does not exist or
/// cannot be merged, or if the error would become larger than allowed; the edges before it are then
/// merged.
void merge_named_edges(MergeTrial& trial, const std::vector<int>& edges);

}  // namespace gradmesh
