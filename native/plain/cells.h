#pragma once

#include "plain/plain_grid.h"

namespace gradmesh {

/// How many patches of a grid look crushed, by the smallest of 12 x 12 cells of each.
struct CrushedPatches {
  /// Those whose smallest cell is less than a tenth of their mean: lines nearly touch there, and
  /// what was soft between them becomes a hard, jagged edge.
  int pinched = 0;
  /// Those of them that have a cell turned over, so that the patch lies over itself.
  int folded = 0;

  /// Returns true if there are no more of either kind than elsewhere.
  bool are_no_more_than(const CrushedPatches& elsewhere) const {
    return pinched <= elsewhere.pinched && folded <= elsewhere.folded;
  }
};

/// Counts the patches of a grid that look crushed. Those that have no size in all are left out.
CrushedPatches crushed_patches(const PlainGrid& grid);

}  // namespace gradmesh
