#pragma once

#include <functional>
#include <vector>

#include "base/affine.h"
#include "geom/box.h"
#include "mesh/mesh.h"

namespace gradmesh {

/// Returns the boundary of the mesh as closed loops of leaves, each leaf starting where the one
/// before ends. A point through which the boundary passes more than once may join loops or part
/// them.
std::vector<std::vector<Halfedge>> boundary_loops(const Mesh& mesh);

/// Returns for each face (by index) a number that all faces of its connected part of the mesh
/// share. Faces that meet in points only are not connected, nor are faces across curves for which
/// `divides` returns true.
std::vector<int> face_components(
    const Mesh& mesh,
    const std::function<bool(Halfedge)>& divides = [](Halfedge) { return false; });

/// Returns the sides of these faces that bound them: those with a face across their curve that is
/// none of them, or with no face there.
std::vector<Halfedge> outer_sides(const Mesh& mesh, const std::vector<Face>& faces);

/// Returns the box around the mesh as `view` shows it, from the sides of its patches with their
/// exact extrema: the box does not depend on how finely the mesh is divided.
Box bounding_box(const Mesh& mesh, const Affine& view);

}  // namespace gradmesh
