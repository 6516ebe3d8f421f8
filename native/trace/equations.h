#pragma once

#include <array>
#include <vector>

#include "fit/equations.h"
#include "trace/line_grid.h"
#include "trace/target_picture.h"

namespace gradmesh {

/// The columns of what a fit may change of a point: how far it goes along its ways
/// (LineGrid::Knot), in pixels of the target, and its red, green, blue and, where the target is not
/// opaque, opacity in levels, one after the other. -1 is for what stays.
struct KnotColumns {
  std::array<int, 2> place{-1, -1};
  int color = -1;
};

/// The columns of some points of a grid; all other points stay.
class GridColumns {
 public:
  /// Numbers the points from one line along rows or columns to another, both included.
  GridColumns(const LineGrid& grid, const TargetPicture& target, Along along, int first, int last);
  /// Numbers all points.
  GridColumns(const LineGrid& grid, const TargetPicture& target)
      : GridColumns(grid, target, Along::rows, 0, grid.rows()) {}

  int count() const { return count_; }
  const KnotColumns& of(int number) const { return columns_[std::size_t(number)]; }

 private:
  std::vector<KnotColumns> columns_;
  int count_ = 0;
};

/// Returns the sum of the squares by which the pixels of a patch differ from the target, in levels,
/// each by its weight: colours count by the square of the target's opacity, too.
double patch_squares(const LineGrid& grid, int row, int column, const TargetPicture& target);

/// Returns the equations of a patch to first order in what the columns number, as those of
/// fit/equations.h but pixel by pixel: at a fixed place of the picture the colour changes with the
/// patch's colours, and with its points as much as colour changes along the way there.
NormalEquations patch_equations(const LineGrid& grid, int row, int column,
                                const TargetPicture& target, const GridColumns& columns);

/// Returns the equations of a patch for each channel alone, in columns that are the numbers of the
/// points: colours and opacity do not depend on each other.
std::vector<NormalEquations> channel_equations(const LineGrid& grid, int row, int column,
                                               const TargetPicture& target);

/// Returns how many channels of a target count: without opacity where it is opaque.
inline int channels(const TargetPicture& target) { return target.is_opaque ? 3 : 4; }

/// Returns a way of a point in pixels, of length 1.
glm::dvec2 way_in_pixels(const LineGrid::Knot& knot, std::size_t way, glm::dvec2 pixels_per_unit);

/// Returns the map from the units of the grid to pixels of the target.
glm::dvec2 pixels_per_unit(const LineGrid& grid, const TargetPicture& target);

}  // namespace gradmesh
