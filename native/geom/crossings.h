#pragma once

#include <vector>

#include "geom/outline.h"

namespace gradmesh {

/// Where a horizontal line enters or leaves polygons.
struct Crossing {
  double x;
  /// 1 where the polygon's side runs down, -1 where it runs up.
  int winding;
};

/// Returns the crossings of the lines y = (k + `offset`) / `a_row`, 0 <= k < `lines`, each from
/// left to right. A side owns its upper end and not its lower one, so that corners count once.
std::vector<std::vector<Crossing>> crossings(const Outline& outline, int a_row, double offset,
                                             int lines);

/// Returns whether a line is inside of polygons after crossings whose windings have that sum.
inline bool is_inside(int winding, FillRule rule) {
  return rule == FillRule::evenodd ? winding % 2 != 0 : winding != 0;
}

}  // namespace gradmesh
