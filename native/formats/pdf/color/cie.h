#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace gradmesh {

/// Returns the matrix from CIE XYZ under this white point to linear sRGB, adapted by Bradford.
/// Throws an InputError if the white point is none.
glm::dmat3 xyz_to_linear_srgb(const glm::dvec3& white_point);

/// Returns sRGB, 0..1, of linear sRGB; what is beyond sRGB is clipped.
glm::dvec3 encoded_srgb(const glm::dvec3& linear);

/// Returns CIE XYZ of CIE L*a*b* under this white point.
glm::dvec3 lab_to_xyz(const glm::dvec3& lab, const glm::dvec3& white_point);

}  // namespace gradmesh
