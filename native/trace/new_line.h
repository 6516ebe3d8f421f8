#pragma once

#include <optional>

#include "trace/line_grid.h"
#include "trace/target_picture.h"

namespace gradmesh {

/// A line that a grid may get (LineGrid::with_line).
struct NewLine {
  Along along = Along::rows;
  int strip = 0;
  /// By how much less the squares are expected to be, for each of the line's points.
  double gain = 0;
};

/// At most how many rows and columns of patches a grid may have.
struct MostLines {
  int rows, columns, points;
};

/// Returns the new line that gains most for each of its points, by one step of Gauss-Newton of
/// these alone; nothing where the grid may not have one more.
std::optional<NewLine> best_new_line(const LineGrid& grid, const TargetPicture& target,
                                     const MostLines& most);

}  // namespace gradmesh
