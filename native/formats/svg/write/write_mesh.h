#pragma once

#include <string>

#include "formats/svg/read/document.h"
#include "formats/svg/read/objects.h"
#include "mesh/mesh.h"
#include "mesh/parts.h"

namespace gradmesh {

/// Gives an object that a mesh gradient paints a new gradient, with fewer rows and columns: the
/// object is otherwise unchanged, and the new gradient has the old one's units, transform and type.
/// The old gradient is removed if nothing else uses it. The mesh is a grid (find_grid), bilinear,
/// in the coordinates of read_mesh, with one colour at each point; `coons_tolerance` is that of
/// BlockForm. What the object remembers (formats/svg/read/written_gradient.h) is taken from it.
/// Returns the object with its new gradient.
MeshObject write_mesh_gradient(SvgDocument& document, const MeshObject& object, const Mesh& mesh,
                               double coons_tolerance);

/// Makes an object that was just written so remember `original`, the value of its attribute. Does
/// nothing if the coordinates are too fine for a step.
void remember_original(SvgDocument& document, const MeshObject& written, double coons_tolerance,
                       const std::string& original);

/// Returns the mesh that a reader finds in the gradient that write_mesh_gradient writes, in the
/// coordinates of the mesh; `to_gradient` maps these to those of the gradient.
MeshParts gradient_parts(const Mesh& mesh, double coons_tolerance, const Affine& to_gradient);

}  // namespace gradmesh
