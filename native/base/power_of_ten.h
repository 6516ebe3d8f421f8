#pragma once

#include <cmath>
#include <cstdlib>

namespace gradmesh {

/// Returns the number that is nearest to 10 to the power of `exponent`, at least from -22 to 22,
/// where the C library of MinGW returns the next one for some.
inline double power_of_ten(int exponent) {
  constexpr int largest_exact = 22;
  if (std::abs(exponent) > largest_exact) return std::pow(10.0, exponent);
  double power = 1;
  for (int i = 0; i < std::abs(exponent); ++i) power *= 10;
  return exponent < 0 ? 1 / power : power;
}

}  // namespace gradmesh
