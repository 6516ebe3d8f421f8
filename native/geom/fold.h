#pragma once

#include "geom/outline.h"
#include "geom/patch.h"

namespace gradmesh {

/// Returns true if a patch lies over itself: it turns to its other side somewhere, by more than
/// what rounds its points. Its outline then leaves out some of what it covers, as the turns of
/// sheets that lie over one another cancel.
bool folds(const Patch& patch);

/// Returns what a patch covers as 16 x 16 quadrilaterals of its surface, which all turn the same
/// way, for the fill rule nonzero.
Outline covered_cells(const Patch& patch);

}  // namespace gradmesh
