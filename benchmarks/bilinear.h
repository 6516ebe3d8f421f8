#pragma once

#include "mesh/build.h"
#include "mesh/color_model.h"
#include "mesh/subdivide.h"

namespace gradmesh::bench {

/// The same patches with nothing but the colours of their corners: all that cairo can paint.
inline Mesh bilinear(const Mesh& mesh) { return build_mesh(as_bilinear(subdivided(mesh, 1))); }

}  // namespace gradmesh::bench
