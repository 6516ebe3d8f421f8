#pragma once

#include <vector>

#include "formats/pdf/page/graphics_state.h"

namespace gradmesh {

/// Lets shadings that are alone in their group have its opacity and blend mode themselves, and
/// takes them out of it, and of groups that change nothing. The other groups are mixed as a whole.
void leave_lone_groups(std::vector<PaintedShading>& painted);

}  // namespace gradmesh
