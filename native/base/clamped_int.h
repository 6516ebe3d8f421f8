#pragma once

namespace gradmesh {

/// Returns a number without its fraction, within [low, high]; `low` for what is no number. A
/// coordinate of a stranger's document may lie beyond the range of an int, where the conversion
/// itself is undefined: so every number that is measured or read becomes an index in this way.
constexpr int clamped_int(double x, int low, int high) {
  if (!(x > low)) return low;
  return x < high ? static_cast<int>(x) : high;
}

/// Farther than any picture reaches, and so close that an int holds sums of a few of these.
inline constexpr int beyond_pictures = 1 << 24;

/// Returns the pixel of a coordinate that is whole, within `beyond_pictures` of the origin.
constexpr int clamped_pixel(double x) { return clamped_int(x, -beyond_pictures, beyond_pictures); }

}  // namespace gradmesh
