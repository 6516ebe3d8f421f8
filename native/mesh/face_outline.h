#pragma once

#include "geom/outline.h"
#include "mesh/mesh.h"

namespace gradmesh {

/// Returns the outline of a face as a polygon, in mesh units. It is off the sides by at most a
/// thousandth of the face's size, if that takes no more than 64 pieces a side; a straight side is
/// one piece. Of a patch that folds it is what that covers, in many pieces.
FilledOutline face_outline(const Mesh& mesh, Face face);

}  // namespace gradmesh
