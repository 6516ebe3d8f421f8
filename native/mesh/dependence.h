#pragma once

#include <span>
#include <vector>

#include "mesh/mesh.h"

namespace gradmesh {

/// A curve depends on another if one of its ends is a T-junction on the other, with which it then
/// moves. A mesh can only be drawn while no curve depends on itself, directly or not (paper 4.4).

/// Returns the curves on which `curve` depends directly: none, one or two.
std::vector<Halfedge> supports(const Mesh& mesh, Halfedge curve);

/// Returns `curves` and all curves that depend on them, directly or not, each after those it
/// depends on. Curves are given and returned as Mesh::curve names them. Where the mesh has a cycle,
/// its curves come in no useful order.
std::vector<Halfedge> in_order_of_dependence(const Mesh& mesh, std::span<const Halfedge> curves);

/// Returns true if some curve depends on itself, directly or not.
bool has_cycle(const Mesh& mesh);

/// Returns the position and colour of the T-junction from which a stem starts, computed from the
/// parent's curve.
Value junction_value(const Mesh& mesh, Halfedge stem);

}  // namespace gradmesh
