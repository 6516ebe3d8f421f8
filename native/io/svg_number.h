#pragma once

#include <charconv>
#include <glm/vec2.hpp>
#include <string>

namespace gradmesh {

/// Decimal digits kept of a coordinate: Inkscape keeps eight when it writes.
inline constexpr int coordinate_digits = 9;

/// The number with at most `digits` significant digits, independent of the locale.
inline std::string format_number(double value, int digits = coordinate_digits) {
  char text[32];
  const auto end =
      std::to_chars(text, text + sizeof text, value + 0.0, std::chars_format::general, digits);
  return {text, end.ptr};
}

/// The shortest text that reads back as the very same number.
inline std::string format_exactly(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

inline std::string format_point(glm::dvec2 p, int digits = coordinate_digits) {
  return format_number(p.x, digits) + "," + format_number(p.y, digits);
}

}  // namespace gradmesh
