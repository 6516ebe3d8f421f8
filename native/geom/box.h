#pragma once

#include <glm/vec2.hpp>

namespace gradmesh {

/// Bounding box with lowest and highest coordinates; empty until a point is added.
class Box {
 public:
  void add(glm::dvec2 p);
  /// Adds the cubic Bezier curve, with its exact extrema.
  void add_cubic(glm::dvec2 p0, glm::dvec2 p1, glm::dvec2 p2, glm::dvec2 p3);
  bool empty() const { return empty_; }
  glm::dvec2 low() const { return low_; }
  glm::dvec2 high() const { return high_; }
  glm::dvec2 size() const { return high_ - low_; }

 private:
  glm::dvec2 low_{0.0}, high_{0.0};
  bool empty_ = true;
};

/// Returns what two boxes share; empty if that has no area.
Box overlap(const Box& a, const Box& b);

}  // namespace gradmesh
