#pragma once

#include <glm/vec2.hpp>
#include <vector>

namespace gradmesh {

/// Returns the convex polygon around points, clockwise (y down), by Andrew's monotone chain.
std::vector<glm::dvec2> convex_hull(std::vector<glm::dvec2> points);

}  // namespace gradmesh
