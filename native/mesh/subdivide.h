#pragma once

#include "mesh/mesh.h"

namespace gradmesh {

/// Places on a curve that are closer, as shares of it, are one.
inline constexpr double same_place = 1e-9;

/// The mesh with every patch split exactly (A.1) into n x n of equal parameters, n at least 1; it
/// paints the same. One thing cannot be exact: in `bicubic` both sides of a curve share their
/// colour tangents, so that beside a T-junction with colours of its own (HalfedgeRecord::own_color)
/// colours keep their values at the new corners, but not all between them. Patches are in the order
/// of the faces, those of one face row by row. Where both sides of a curve are divided at the same
/// place (same_place) the curve is cut there, so that a plain grid stays one; elsewhere
/// the new points on curves are T-junctions.
/// Not of smooth meshes, whose colours would follow other neighbours.
MeshParts subdivided(const Mesh& mesh, int n);

}  // namespace gradmesh
