#pragma once

#include <vector>

#include "methods/patch_set.h"

namespace gradmesh {

/// Something that can be merged: the patches that it takes, how many of them it saves, and by how
/// much it raises the error, which must be finite.
struct PackingItem {
  PatchSet patches;
  int saved;
  double price;
};

/// Items by their numbers.
using Packing = std::vector<int>;

struct BestPacking {
  /// By rising numbers.
  Packing items;
  /// Whether it is certain that no other set is better by more than a millionth of gamma.
  bool proven = false;
};

/// Of all the sets of items without common patches whose prices add up to at most `gamma`, 0 or
/// more, the one that saves the most patches, and of those the one with the smallest sum, to a
/// millionth of gamma. An integer program, with a row for each patch that several items take.
/// The search for either ends after `most_nodes` nodes of its tree, and where the program without
/// its integrality takes too many pivots: never after some time, so that the result is always the
/// same. It is never worse than `start`, any such set.
BestPacking best_packing(const std::vector<PackingItem>& items, double gamma, const Packing& start,
                         int most_nodes);

}  // namespace gradmesh
