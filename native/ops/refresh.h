#pragma once

#include <span>

#include "ops/journal.h"

namespace gradmesh {

/// Puts the T-junctions of the changed curves, and of all curves that depend on them, back on their
/// parents, colours too, and marks the faces along all these curves as touched. The curves are
/// given as Mesh::curve names them.
void refresh(Journal& journal, std::span<const Halfedge> changed_curves);

/// Puts the T-junctions of one curve back on it, without those of the curves that depend on it.
void refresh_curve(Journal& journal, Halfedge curve);

}  // namespace gradmesh
