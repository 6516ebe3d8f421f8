#pragma once

#include "session/edits.h"
#include "session/pointing.h"

namespace gradmesh {

/// Edits of single sides, points, handles and colours, as a person makes them by hand. Nothing is
/// fitted after them but where that is said. All throw InputError where a patch that is protected
/// would change.

/// Returns the mesh with a side straight. Throws InputError if there is no side, and if it is
/// straight.
EditedMesh straightened(const Mesh& mesh, const Pointed& pointed);

/// Returns the mesh with a straight side as a curve whose handles are fitted to the picture. Throws
/// InputError if there is no side, if it is a curve, and if the mesh is smooth.
EditedMesh bent(const Mesh& mesh, const Pointed& pointed, const Reference& picture);

/// Returns the mesh with a point, and the handles there with it, or with a handle at a place in
/// mesh units. Throws InputError if what moves would leave the frame of the problem, in which the
/// error is measured.
EditedMesh moved(const Mesh& mesh, const Grip& grip, glm::dvec2 to, const Problem& problem);

/// Returns the mesh with a colour, (r, g, b), 0..1, at the corner of a patch, or at all corners
/// around its point. Opacities stay. Throws InputError if there is no corner.
EditedMesh recolored(const Mesh& mesh, const Pointed& pointed, const glm::dvec3& color,
                     bool is_sharp);

/// Returns the mesh with one colour again around a point, as of join_colors(). Throws InputError if
/// there is no corner, and if there is one colour already.
EditedMesh joined(const Mesh& mesh, const Pointed& pointed);

}  // namespace gradmesh
