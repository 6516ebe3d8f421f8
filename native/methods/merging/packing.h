#pragma once

#include <vector>

#include "methods/merging/patch_set.h"

namespace gradmesh {

/// A merge, by the patches that it takes, how many of them it saves, and by how much it raises the
/// error, which must be finite.
struct PackingItem {
  PatchSet patches;
  int saved;
  double price;
};

/// Indices of items.
using Packing = std::vector<int>;

struct BestPacking {
  /// The items, by rising index.
  Packing items;
  /// True if it is certain that no other set is better by more than a millionth of gamma.
  bool proven = false;
};

/// Returns, of all the sets of items without common patches whose prices add up to at most `gamma`,
/// 0 or more, the one that saves the most patches, and of those the one with the smallest sum of
/// prices, to a millionth of gamma. Solves an integer program with a row for each patch that
/// several items take. The search for either ends after `most_nodes` nodes of its tree, or if the
/// relaxation takes too many pivots, but never after some time, so that the result is always the
/// same. The result is never worse than `start`, which must be such a set.
BestPacking best_packing(const std::vector<PackingItem>& items, double gamma, const Packing& start,
                         int most_nodes);

}  // namespace gradmesh
