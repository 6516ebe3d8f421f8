#include "methods/plain/flaws.h"

#include <algorithm>

#include "methods/plain/border.h"
#include "methods/plain/corners.h"

namespace gradmesh {
namespace {

/// Fits after a step may turn corners a little further than where they are first seen.
constexpr double most_corner = 1.5 * seen_corner;

}  // namespace

Flaws::Flaws(const PlainGrid& start, const Reference& picture)
    : picture_(picture),
      largest_corner_(std::max(most_corner, largest_corner(start))),
      largest_gap_(std::max(seen_gap, border_gap(start, picture))),
      crush_(start) {}

bool Flaws::are_worse(const PlainGrid& grid) const {
  return largest_corner(grid) > largest_corner_ || border_gap(grid, picture_) > largest_gap_ ||
         crush_.is_worse(grid);
}

}  // namespace gradmesh
