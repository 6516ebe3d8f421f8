#pragma once

#include <span>

#include "ops/journal.h"

namespace gradmesh {

/// Gives a curve, as Mesh::curve names it, the tangents of its chord. T-junctions on the curve stay
/// where they are until refresh().
void straighten(Journal& journal, Halfedge curve);

/// Gives a face the twists of the Coons patch with its sides.
void drop_tensor(Journal& journal, Face face);

}  // namespace gradmesh
