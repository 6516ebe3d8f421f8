#pragma once

#include <vector>

#include "base/progress.h"
#include "trace/line_grid.h"
#include "trace/target_picture.h"

namespace gradmesh {

/// Returns what is left of a grid that was traced from the target each time the line that costs
/// least for each of its points is taken out and all points and colours are fitted again. Each has
/// fewer points than the one before, and colours in whole levels. The last one has no line that can
/// be taken out, or is the last that the watch allows; there is none if that holds for the grid
/// itself.
std::vector<LineGrid> thinned_grids(const LineGrid& grid, const TargetPicture& target,
                                    StopWatch& watch);

}  // namespace gradmesh
