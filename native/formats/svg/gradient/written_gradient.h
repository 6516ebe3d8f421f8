#pragma once

#include <optional>
#include <string>

#include "formats/svg/tree/objects.h"
#include "formats/svg/tree/svg_tree.h"
#include "mesh/mesh.h"

namespace gradmesh {

/// An object whose mesh gradient gradmesh has written remembers its original in attributes of our
/// own namespace, ROLE being `fill` or `stroke`:
///   ROLE-original  the mesh before it was first simplified, in the coordinates of the gradient
///                  (formats/svg/group/memory.h)
///   ROLE-written   the fingerprint of the gradient as it was written, which tells whether a person
///                  has edited it since
/// They are on the object, as Inkscape gives a copy of an object a new gradient without attributes.
/// They are in the coordinates of the gradient, as those stay the same where an object is moved:
/// that changes gradientTransform alone.

/// Returns the value of ROLE-original; nothing if there is none.
std::optional<std::string> original_of(const MeshObject& object);

/// Returns true if the object has a fingerprint, and its gradient still is what the fingerprint was
/// made of. Throws InputError as gradient_patches does.
bool is_as_written(const SvgTree& tree, const MeshObject& object);

/// Makes an object whose gradient was just written by write_mesh_gradient() with this mesh and this
/// tolerance remember `original`, if that is not empty, and what was written. Does nothing if the
/// coordinates are too fine for a step.
void remember_original(SvgTree& tree, const MeshObject& object, const Mesh& mesh,
                       double coons_tolerance, const std::string& original);
/// Removes both attributes, and the texts of colours (formats/svg/gradient/color_texts.h).
void forget_original(const MeshObject& object);

}  // namespace gradmesh
