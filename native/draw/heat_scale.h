#pragma once

#include <glm/vec3.hpp>
#include <string>

namespace gradmesh {

/// Returns the colour of `t` in [0, 1], as sRGB in 0..1: from cream over orange and red to a dark
/// violet. The lightness falls evenly, so that order and distances show on paper, on any screen and
/// to people who do not tell red from green.
glm::dvec3 heat_color(double t);

/// A scale on which errors are laid out evenly by their logarithm, since the prices of a mesh
/// spread over many powers of ten.
class HeatScale {
 public:
  /// Length of the scale in powers of ten, below `highest`, which is above 0.
  static constexpr double decades = 3;

  explicit HeatScale(double highest) : highest_(highest) {}
  double highest() const { return highest_; }
  double lowest() const;
  /// Returns 0 for `lowest` and all below, 1 for `highest` and all above.
  double position(double error) const;
  /// Returns the colour as "#rrggbb". The colours begin a little above the cream, to be seen on
  /// white.
  std::string color(double error) const { return color_at(position(error)); }
  static std::string color_at(double position);

 private:
  double highest_;
};

/// Returns "#rrggbb" of an sRGB colour, clamped to 0..1.
std::string hex_color(const glm::dvec3& color);

}  // namespace gradmesh
