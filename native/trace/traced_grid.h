#pragma once

#include <functional>

#include "base/progress.h"
#include "trace/line_grid.h"
#include "trace/target_picture.h"

namespace gradmesh {

struct GridOptions {
  /// At most how many points the grid may have, at least 4.
  int points = 1000;
  /// Returns true if a grid is close enough to the picture, which then is not followed further, and
  /// of whose lines those are taken out that it does not need. Nothing for what is no difference in
  /// whole levels.
  std::function<bool(const LineGrid&)> is_enough = {};
};

/// Returns a grid over (0, 0) to `size` whose picture is close to the target, with colours in whole
/// levels. Lines are put in one after the other where they gain most, exchanged and taken out, and
/// all is fitted again, on smaller pictures first. Where the watch stops it, returns the best grid
/// so far.
LineGrid traced_grid(const TargetPicture& target, glm::dvec2 size, const GridOptions& options,
                     StopWatch& watch);

}  // namespace gradmesh
