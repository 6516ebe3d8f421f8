#include "geom/box.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

namespace gradmesh {
namespace {

/// Returns the parameters in (0, 1) at which one coordinate of a cubic Bezier curve has an
/// extremum; unused elements are 0.
std::array<double, 2> turning_points(double p0, double p1, double p2, double p3) {
  // Derivative / 3 = a t^2 - 2 b t + c.
  double a = p3 - 3 * p2 + 3 * p1 - p0, b = -(p2 - 2 * p1 + p0), c = p1 - p0;
  std::array<double, 2> turns{};
  const double largest = std::max({std::abs(a), std::abs(b), std::abs(c)});
  if (largest == 0) return turns;
  // Squares of tiny coefficients would be 0. A power of two changes no digit.
  for (double* coefficient : {&a, &b, &c})
    *coefficient = std::scalbn(*coefficient, -std::ilogb(largest));
  const double discriminant = b * b - a * c;
  if (discriminant < 0) return turns;
  // The root with the larger numerator directly, the other by Vieta: no cancellation, and the
  // quadratic may degenerate (a = 0).
  const double q = b + std::copysign(std::sqrt(discriminant), b);
  if (a != 0) turns[0] = q / a;
  if (q != 0) turns[1] = c / q;
  for (double& t : turns)
    if (!(t > 0 && t < 1)) t = 0;
  return turns;
}

double cubic_at(double p0, double p1, double p2, double p3, double t) {
  const double s = 1 - t;
  return s * s * s * p0 + 3 * s * s * t * p1 + 3 * s * t * t * p2 + t * t * t * p3;
}

}  // namespace

void Box::add(glm::dvec2 p) {
  low_ = empty_ ? p : glm::min(low_, p);
  high_ = empty_ ? p : glm::max(high_, p);
  empty_ = false;
}

void Box::add_cubic(glm::dvec2 p0, glm::dvec2 p1, glm::dvec2 p2, glm::dvec2 p3) {
  add(p0);
  add(p3);
  for (int axis = 0; axis < 2; ++axis)
    for (const double t : turning_points(p0[axis], p1[axis], p2[axis], p3[axis])) {
      // Only this axis turns here; on the other one any point of the curve lies in the box anyway.
      glm::dvec2 p;
      for (int i = 0; i < 2; ++i) p[i] = cubic_at(p0[i], p1[i], p2[i], p3[i], t);
      add(p);
    }
}

Box overlap(const Box& a, const Box& b) {
  Box both;
  const glm::dvec2 low = glm::max(a.low(), b.low()), high = glm::min(a.high(), b.high());
  if (a.empty() || b.empty() || !(low.x < high.x && low.y < high.y)) return both;
  both.add(low);
  both.add(high);
  return both;
}

}  // namespace gradmesh
