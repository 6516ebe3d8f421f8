#pragma once

#include <vector>

#include "base/image.h"
#include "geom/patch.h"
#include "methods/plain/plain_grid.h"
#include "methods/plain/steps.h"
#include "raster/frame.h"
#include "reference/reference.h"

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

/// The distance in pixels from which a gap between the border of a mesh and where it was is seen.
inline constexpr double seen_gap = 1;

/// Returns how far the border of a grid is from the outlines of the original, in pixels, where it
/// is not hidden: at most a little more than Reference::outline_near looks. An error over all of
/// the picture does not tell such a gap at the edge of an object, which is a few pixels.
double border_gap(const PlainGrid& grid, const Reference& picture);

/// A corner of a line that was smooth is seen from about here: the sine of its angle times the
/// difference of colour to the lines beside it. No metric tells such corners: a mean is small where
/// an artist sees an eyelid become angular.
inline constexpr double seen_corner = 0.15;

/// Returns how much is seen of the most visible corner between two straight sides of a line that
/// was smooth, as of seen_corner; 0 if there is none.
double largest_corner(const PlainGrid& grid);

/// Returns true if a line that was smooth would have a corner that is seen at one end of the side
/// if the side became straight. There is none where the other side stays a curve, which then
/// follows.
bool makes_corner(const PlainGrid& grid, const Side& side);

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

/// Returns which of the sides that became straight in a grid harm details: those along which the
/// errors of details (metric/detail_errors.h) are above the bound, and of all the closest to where
/// the error is largest. None if no side is near that.
std::vector<Side> harmful_sides(const std::vector<Side>& sides, const PlainGrid& grid,
                                const Plane& errors, double bound, const Frame& frame);

}  // namespace gradmesh
