#pragma once

#include <glm/vec3.hpp>
#include <string>

namespace gradmesh {

/// Returns the colour of `t` in [0, 1], as sRGB in 0..1: from cream over orange and red to a dark
/// violet. The lightness falls evenly, so that order and distances show on paper, on any screen and
/// to people who do not tell red from green.
glm::dvec3 heat_color(double t);

/// Returns "#rrggbb" of an sRGB colour, clamped to 0..1.
std::string hex_color(const glm::dvec3& color);

/// A scale on which errors are laid out evenly by their logarithm, since the prices of a mesh
/// spread over many powers of ten.
class HeatScale {
 public:
  /// Length of a scale in powers of ten, where nothing else is said.
  static constexpr double decades = 3;

  /// Makes a scale of some length in powers of ten, below `highest`, which is above 0.
  explicit HeatScale(double highest, double length = decades)
      : highest_(highest), length_(length) {}
  double highest() const { return highest_; }
  double lowest() const;
  /// Returns 0 for `lowest` and all below, 1 for `highest` and all above.
  double position(double error) const;
  /// Returns the error whose position that is.
  double error_at(double position) const;
  /// Returns the colour as "#rrggbb". The colours begin a little above the cream, to be seen on
  /// white.
  std::string color(double error) const { return color_at(position(error)); }
  static std::string color_at(double position) { return hex_color(rgb_at(position)); }
  /// Returns the same as sRGB in 0..1.
  static glm::dvec3 rgb_at(double position);

 private:
  double highest_, length_;
};

}  // namespace gradmesh
