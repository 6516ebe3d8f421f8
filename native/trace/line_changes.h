#pragma once

#include <optional>

#include "trace/line_grid.h"
#include "trace/target_picture.h"

namespace gradmesh {

/// A line that a grid may get, by the strip that it divides (LineGrid::with_line), or may lose, by
/// its number (LineGrid::without_line).
struct LineChange {
  Along along = Along::rows;
  int number = 0;
  /// By how much less, or more, the squares, with those of what strays from guides, are expected to
  /// be, for each of the line's points.
  double squares = 0;
};

/// At most how many rows and columns of patches, and points, a grid may have.
struct MostLines {
  int rows, columns, points;
};

/// Returns the new line that gains most for each of its points, by one step of Gauss-Newton of
/// these alone; nothing where the grid may not have one more. Slivers count as they do in
/// sliver_squares by the weight `slivers`.
std::optional<LineChange> best_new_line(const LineGrid& grid, const TargetPicture& target,
                                        const MostLines& most, double slivers);

/// Returns the line that costs least for each of its points where it is taken out, after one step
/// of Gauss-Newton of the lines on both sides of it; nothing where there is none that can be
/// lost, or none without which no patch folds.
std::optional<LineChange> cheapest_line(const LineGrid& grid, const TargetPicture& target,
                                        double slivers);

}  // namespace gradmesh
