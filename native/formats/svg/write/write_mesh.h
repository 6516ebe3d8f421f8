#pragma once

#include "formats/svg/read/document.h"
#include "formats/svg/read/objects.h"
#include "mesh/mesh.h"
#include "mesh/parts.h"

namespace gradmesh {

/// Gives an object that a mesh gradient paints a new one, with fewer rows and columns: the object
/// stays what and where it is, and the gradient keeps its units, transform and type. The old
/// gradient goes where nothing else uses it. The mesh is a grid (find_grid), bilinear, in the
/// coordinates of read_mesh, with one colour at each point; `coons_tolerance` as of BlockForm.
void write_mesh_gradient(SvgDocument& document, const MeshObject& object, const Mesh& mesh,
                         double coons_tolerance);

/// The mesh as a reader of what write_mesh_gradient writes finds it.
MeshParts gradient_parts(const Mesh& mesh, double coons_tolerance);

}  // namespace gradmesh
