#include "formats/pdf/color/cie.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>

#include "base/error.h"

namespace gradmesh {
namespace {

constexpr glm::dvec3 d65_white{0.9505, 1, 1.089};

/// From XYZ to the responses of cones by which Bradford's adaptation scales.
const glm::dmat3 bradford_cones(0.8951, -0.7502, 0.0389,  //
                                0.2664, 1.7135, -0.0685,  //
                                -0.1614, 0.0367, 1.0296);

/// Of linear sRGB (IEC 61966-2-1), columns red, green and blue.
const glm::dmat3 srgb_to_xyz(0.4124, 0.2126, 0.0193,  //
                             0.3576, 0.7152, 0.1192,  //
                             0.1805, 0.0722, 0.9505);

glm::dmat3 scaling(const glm::dvec3& s) { return {s.x, 0, 0, 0, s.y, 0, 0, 0, s.z}; }

}  // namespace

glm::dmat3 xyz_to_linear_srgb(const glm::dvec3& white_point) {
  const glm::dvec3 cones = bradford_cones * white_point;
  // Whites of lights have Y = 1; these bounds keep all that is computed finite.
  const auto is_near_one = [](const glm::dvec3& v) {
    return glm::all(glm::greaterThan(v, glm::dvec3(1e-3))) &&
           glm::all(glm::lessThan(v, glm::dvec3(1e3)));
  };
  if (!is_near_one(white_point) || !is_near_one(cones))
    throw InputError("a colour space of its shading has no white point");
  const glm::dmat3 adapted =
      glm::inverse(bradford_cones) * scaling(bradford_cones * d65_white / cones) * bradford_cones;
  return glm::inverse(srgb_to_xyz) * adapted;
}

glm::dvec3 encoded_srgb(const glm::dvec3& linear) {
  glm::dvec3 encoded;
  for (int i = 0; i < 3; ++i) {
    const double x = linear[i] > 0 ? std::fmin(linear[i], 1) : 0;
    encoded[i] = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
  }
  return encoded;
}

glm::dvec3 lab_to_xyz(const glm::dvec3& lab, const glm::dvec3& white_point) {
  // The inverse of CIE's cube root, linear near black (ISO 32000-1, 8.6.5.4).
  const auto decoded = [](double x) {
    return x >= 6.0 / 29 ? x * x * x : 108.0 / 841 * (x - 4.0 / 29);
  };
  const double m = (lab.x + 16) / 116;
  return white_point * glm::dvec3(decoded(m + lab.y / 500), decoded(m), decoded(m - lab.z / 200));
}

}  // namespace gradmesh
