#pragma once

#include "ops/journal.h"

namespace gradmesh {

/// Splits the patch of the leaf `side` exactly in two (A.1), from the point t of that side to the
/// point 1 - t of the side opposite, as one operation of the journal. The new edge ends at
/// T-junctions where another patch lies across, and at points on the boundary. t in (0, 1).
/// Returns the new edge. It starts on `side`, and its face is the old one, which keeps [0, t].
Halfedge split(Journal& journal, Halfedge side, double t);

}  // namespace gradmesh
