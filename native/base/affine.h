#pragma once

#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>

namespace gradmesh {

/// Affine map of the plane, p -> linear * p + offset. SVG's `matrix(a b c d e f)` has the columns
/// (a, b), (c, d) and the offset (e, f).
struct Affine {
  glm::dmat2 linear{1.0};
  glm::dvec2 offset{0.0};

  bool operator==(const Affine&) const = default;

  static Affine translation(glm::dvec2 by) { return {glm::dmat2(1.0), by}; }
  static Affine scaling(glm::dvec2 by) { return {glm::dmat2(by.x, 0, 0, by.y), glm::dvec2(0.0)}; }

  glm::dvec2 point(glm::dvec2 p) const { return linear * p + offset; }
  /// Returns the image of a difference of points or of a derivative, which the offset does not
  /// move.
  glm::dvec2 vector(glm::dvec2 v) const { return linear * v; }
  double determinant() const { return glm::determinant(linear); }
  /// Returns the inverse map. The determinant must not be 0.
  Affine inverse() const {
    const glm::dmat2 back = glm::inverse(linear);
    return {back, -(back * offset)};
  }
};

/// Returns the map that applies `inner` first and then `outer`.
inline Affine operator*(const Affine& outer, const Affine& inner) {
  return {outer.linear * inner.linear, outer.point(inner.offset)};
}

}  // namespace gradmesh
