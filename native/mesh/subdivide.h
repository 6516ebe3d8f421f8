#pragma once

#include "mesh/mesh.h"

namespace gradmesh {

/// Places on a curve that are closer than this, as shares of the curve, count as one.
inline constexpr double same_place = 1e-9;

/// Returns the mesh with every patch split exactly (A.1) into n x n of equal parameters, n at least
/// 1; it paints the same. One thing is not exact: MeshParts, as .hemesh files, have only tangents
/// that both sides of a curve share (no HalfedgeRecord::own_tangents). So in `bicubic`, beside a
/// T-junction with colours of its own, colours keep their values at the new corners, but not all
/// between them. Patches are in the order of the faces, those of one face row by row. Where both
/// sides of a curve are divided at the same place (same_place) the curve is cut there, so that a
/// plain grid stays one; elsewhere the new points on curves are T-junctions. `mesh` is not smooth:
/// the colours of a smooth mesh would follow other neighbours.
MeshParts subdivided(const Mesh& mesh, int n);

}  // namespace gradmesh
