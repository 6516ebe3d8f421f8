#pragma once

#include <glm/vec2.hpp>

namespace gradmesh {

/// Returns the third part of the cross product of two vectors in a plane: twice the area of the
/// triangle between them, positive where the second lies clockwise from the first with y down.
inline double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

}  // namespace gradmesh
