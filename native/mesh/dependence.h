#pragma once

#include <span>
#include <vector>

#include "mesh/mesh.h"

namespace gradmesh {

/// A curve hangs on another where it ends at a T-junction of it: it moves with the other. A mesh
/// can only be drawn while nothing hangs on itself (paper 4.4).

/// The curves on which `curve` hangs directly: none, one or two.
std::vector<Halfedge> supports(const Mesh& mesh, Halfedge curve);

/// `curves` and all that hangs on them, directly or not, each after those it hangs on. Curves
/// are given and returned as Mesh::curve names them. Where the mesh has a cycle, its curves come
/// in no useful order.
std::vector<Halfedge> in_order_of_dependence(const Mesh& mesh, std::span<const Halfedge> curves);

/// Whether some curve hangs on itself.
bool has_cycle(const Mesh& mesh);

/// The T-junction from which a stem starts, worked out from its parent.
Value junction_value(const Mesh& mesh, Halfedge stem);

}  // namespace gradmesh
