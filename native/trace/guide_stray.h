#pragma once

#include "trace/line_grid.h"
#include "trace/target_picture.h"

namespace gradmesh {

/// Returns how much the straight sides of lines that follow guides stray from these: the area
/// between, in pixels of the target, as if each of its pixels were off by as much as is seen. So
/// lines are put across a guide where it bends, and stay, though the picture alone would not need
/// them there. 0 where there are no guides.
double stray_squares(const LineGrid& grid, const TargetPicture& target);

}  // namespace gradmesh
