#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <glm/vec2.hpp>
#include <limits>
#include <string>

#include "form/rounding.h"
#include "geom/box.h"

namespace gradmesh {

/// Decimal digits kept of a coordinate: Inkscape keeps eight when it writes.
inline constexpr int coordinate_digits = 9;
/// Decimal digits kept of the coordinates of outlines, which only have to be large enough.
inline constexpr int outline_digits = 6;

inline double largest_coordinate(const Box& box) {
  return std::max({std::abs(box.low().x), std::abs(box.low().y), std::abs(box.high().x),
                   std::abs(box.high().y)});
}

/// Returns the digits for coordinates inside this box: more than `usual` if the box is far from the
/// origin for its size, as rounding would otherwise deform what lies in it. At least `usual` - 3
/// digits distinguish places along the box's longer side.
inline int digits_within(const Box& box, int usual = coordinate_digits) {
  constexpr int most = 17;  // Tell any two doubles apart.
  const double longer = std::max(box.size().x, box.size().y);
  int digits = usual;
  for (double far = 1000 * longer; far < largest_coordinate(box) && digits < most; far *= 10)
    ++digits;
  return digits;
}

/// How the coordinates of a mesh are rounded.
struct Rounding {
  int digits = coordinate_digits;
  /// Coordinates smaller than this are written as 0: they are left over from roundings of 0.
  double zero = 0;
};

/// Keeps all digits that survive being read and computed with: those after are last bits.
inline constexpr Rounding no_rounding{std::numeric_limits<double>::digits10, 0};

/// Returns the rounding for a mesh; `box` is the box around it.
inline Rounding rounding_within(const Box& box) {
  return {digits_within(box), 1e-12 * largest_coordinate(box)};
}

/// Returns the number with at most `digits` significant digits, independent of the locale.
inline std::string format_number(double value, int digits = coordinate_digits) {
  char text[32];
  const auto end =
      std::to_chars(text, text + sizeof text, value + 0.0, std::chars_format::general, digits);
  return {text, end.ptr};
}

/// Returns a multiple of a decimal step with as many decimals as it needs, and no zero before the
/// point: `-.5`.
inline std::string format_multiple(double value, double step) {
  char text[64];
  const int decimals = int(std::lround(-std::log10(step)));
  const auto end = std::to_chars(text, text + sizeof text, round_to_step(value, step) + 0.0,
                                 std::chars_format::fixed, decimals);
  std::string number(text, end.ptr);
  if (decimals > 0) {
    number.erase(number.find_last_not_of('0') + 1);
    if (number.back() == '.') number.pop_back();
  }
  if (number == "-0") return "0";
  if (const auto zero = number.find("0."); zero == 0 || (zero == 1 && number[0] == '-'))
    number.erase(zero, 1);
  return number;
}

/// Returns the shortest text that reads back as the very same number.
inline std::string format_exactly(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

inline std::string format_point(glm::dvec2 p, int digits = coordinate_digits) {
  return format_number(p.x, digits) + "," + format_number(p.y, digits);
}

}  // namespace gradmesh
