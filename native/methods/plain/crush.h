#pragma once

#include "geom/patch.h"
#include "methods/plain/plain_grid.h"

namespace gradmesh {

/// Returns the smallest of 12 x 12 cells of a patch as a share of their mean: 1 for a
/// parallelogram, or a patch that has no size in all; close to 0 where lines nearly touch, so that
/// what was soft between them becomes a hard, jagged edge; below 0 where the patch lies over
/// itself.
double narrowest_share(const Patch& patch);

/// Returns true if a patch that has moved is much narrower in a place than it was, and narrow.
bool is_pinched(const Patch& moved, const Patch& before);

/// The patches of a grid that look crushed.
class Crush {
 public:
  /// Patches look crushed whose narrowest_share() is below a tenth, and below a fifth of the
  /// smallest in this grid: those at the pole of a round mesh are narrow by nature.
  explicit Crush(const PlainGrid& start);

  /// Returns true if more patches of the grid are crushed, or lie over themselves, than at first.
  bool is_worse(const PlainGrid& grid) const { return !counted(grid).is_at_most(at_first_); }

 private:
  struct Count {
    int pinched = 0, folded = 0;
    bool is_at_most(const Count& other) const {
      return pinched <= other.pinched && folded <= other.folded;
    }
  };

  Count counted(const PlainGrid& grid) const;

  double least_share_;
  Count at_first_;
};

}  // namespace gradmesh
