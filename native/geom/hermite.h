#pragma once

#include <array>

namespace gradmesh {

/// Returns the cubic Hermite basis of Eq. 1 at t: the weights of the value at 0, the derivatives at
/// 0 and 1, and the value at 1.
inline std::array<double, 4> hermite_basis(double t) {
  const double t2 = t * t, t3 = t2 * t;
  return {1 - 3 * t2 + 2 * t3, t - 2 * t2 + t3, t3 - t2, 3 * t2 - 2 * t3};
}

inline std::array<double, 4> hermite_derivative(double t) {
  const double t2 = t * t;
  return {6 * t2 - 6 * t, 1 - 4 * t + 3 * t2, 3 * t2 - 2 * t, 6 * t - 6 * t2};
}

}  // namespace gradmesh
