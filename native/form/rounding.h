#pragma once

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>

#include "base/clamped_int.h"
#include "base/power_of_ten.h"

namespace gradmesh {

/// Returns the largest power of ten that is at most `most` and at most 1: a step for coordinates
/// that need not be finer than `most`. Returns 0 where that has so many decimals that significant
/// digits are shorter.
inline double decimal_step(double most) {
  constexpr double least = 1e-9;
  return most < least ? 0 : power_of_ten(clamped_int(std::floor(std::log10(most) + 1e-9), -400, 0));
}

/// The share of the largest coordinate by which computed coordinates may be off.
inline constexpr double share_of_last_bits = 1e-12;

/// Returns the multiple of a decimal step that is nearest; upwards where two are, up to the last
/// bits of the number: patches that share a point may differ in these.
inline double round_to_step(double value, double step) {
  constexpr double upwards = 1e-4;
  return std::floor(value / step + 0.5 + upwards) * step;
}
inline glm::dvec2 round_to_step(glm::dvec2 p, double step) {
  return {round_to_step(p.x, step), round_to_step(p.y, step)};
}

}  // namespace gradmesh
