#pragma once

#include <vector>

#include "trial/merge_trial.h"

namespace gradmesh {

/// Merges the edges of these half-edges in their order. Throws InputError where one is not there or
/// cannot be merged, or where the error would become larger than allowed; those before it are
/// merged then.
void merge_named_edges(MergeTrial& trial, const std::vector<int>& edges);

}  // namespace gradmesh
