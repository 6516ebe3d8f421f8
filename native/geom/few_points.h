#pragma once

#include <glm/vec2.hpp>
#include <vector>

namespace gradmesh {

/// Returns a closed polygon without the points that its sides pass by no farther than `tolerance`,
/// chosen by the way of Douglas and Peucker (1973). One of fewer than four points stays as it is.
std::vector<glm::dvec2> with_few_points(const std::vector<glm::dvec2>& polygon, double tolerance);

}  // namespace gradmesh
