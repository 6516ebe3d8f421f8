#pragma once

#include "methods/plain/crush.h"
#include "methods/plain/plain_grid.h"
#include "reference/reference.h"

namespace gradmesh {

/// What a person sees of the lines of a grid and no error over all of the picture tells: corners of
/// lines that were smooth, gaps at the border, and crushed patches.
class Flaws {
 public:
  /// Flaws that are there at the start may stay. Keeps `picture`.
  Flaws(const PlainGrid& start, const Reference& picture);

  /// Returns true if more is seen of flaws than at the start.
  bool are_worse(const PlainGrid& grid) const;

 private:
  const Reference& picture_;
  double largest_corner_, largest_gap_;
  Crush crush_;
};

}  // namespace gradmesh
