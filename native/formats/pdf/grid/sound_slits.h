#pragma once

#include <vector>

#include "formats/pdf/grid/loose_sides.h"

namespace gradmesh {

/// Returns which of these slits can be curves of one mesh together (build_mesh): from each of their
/// T-junctions there is one curve between the two patches, which are beside each other; no point is
/// a T-junction twice; and no curve depends on itself (4.4). The others are to be left apart. Of
/// those that do not go together it is not always the fewest.
std::vector<bool> sound_slits(const LooseSides& sides, std::vector<bool> slits);

}  // namespace gradmesh
