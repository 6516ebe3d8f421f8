#pragma once

#include <algorithm>
#include <cstddef>

namespace gradmesh {

/// Of many small steps a portion is made at once: a quarter of all that are possible, and where
/// that is too much a quarter of the portion.
inline constexpr std::size_t portions = 4;

/// Returns how many of the possible steps are made at once at first.
inline std::size_t first_portion(std::size_t possible) {
  return (possible + portions - 1) / portions;
}

/// Returns how many steps are made at once after so many were too much.
inline std::size_t smaller_portion(std::size_t too_many) {
  return std::max<std::size_t>(1, too_many / portions);
}

}  // namespace gradmesh
