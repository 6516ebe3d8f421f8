#pragma once

#include "geom/hermite.h"

namespace gradmesh {

/// Cubic curve in Hermite form over [0, 1]: end values and end derivatives. `V` is a vector
/// with + and * (glm::dvec2, Value).
template <class V>
struct Cubic {
  V p0{}, m0{}, m1{}, p1{};

  bool operator==(const Cubic&) const = default;

  V at(double t) const {
    const auto [of_p0, of_m0, of_m1, of_p1] = hermite_basis(t);
    return p0 * of_p0 + m0 * of_m0 + m1 * of_m1 + p1 * of_p1;
  }

  V derivative(double t) const {
    const double t2 = t * t;
    return (p1 + p0 * -1.0) * (6 * t - 6 * t2) + m0 * (1 - 4 * t + 3 * t2) + m1 * (3 * t2 - 2 * t);
  }

  /// Returns the same curve over [a, b], with its own parameter from 0 to 1.
  Cubic part(double a, double b) const {
    return {at(a), derivative(a) * (b - a), derivative(b) * (b - a), at(b)};
  }

  Cubic reversed() const { return {p1, m1 * -1.0, m0 * -1.0, p0}; }

  /// Return the inner Bezier control points.
  V bezier1() const { return p0 + m0 * (1.0 / 3.0); }
  V bezier2() const { return p1 + m1 * (-1.0 / 3.0); }

  static Cubic from_bezier(const V& b0, const V& b1, const V& b2, const V& b3) {
    return {b0, (b1 + b0 * -1.0) * 3.0, (b3 + b2 * -1.0) * 3.0, b3};
  }
};

}  // namespace gradmesh
