#pragma once

#include "mesh/mesh.h"
#include "mesh/parts.h"

namespace gradmesh {

/// Makes the mesh of the given patches and curves. Corners that meet along curves become one
/// point, at the position that the first of their patches gives; T-junctions are put on their
/// parents. A junction's colour is its own only where the parts say so or it differs visibly from
/// the parent's (by more than the rounding to 8 bits, or to six digits in `bicubic`).
///
/// Half-edge 4 * patch + side keeps its index, and face i is patch i.
/// Throws InputError where the parts do not fit together or a curve depends on itself (4.4), and
/// where there are more patches than the limit (base/limits.h).
Mesh build_mesh(const MeshParts& parts);

/// Makes the mesh as build_mesh() does, of parts that come from a mesh which keeps to the limit:
/// their number is not limited.
Mesh build_derived_mesh(const MeshParts& parts);

}  // namespace gradmesh
