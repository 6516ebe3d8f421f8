#pragma once

#include <glm/vec2.hpp>

#include "geom/cubic.h"

namespace gradmesh {

/// Returns the parameter in [low, high] at which the curve comes nearest to the point.
double nearest(const Cubic<glm::dvec2>& curve, glm::dvec2 point, double low, double high);

}  // namespace gradmesh
