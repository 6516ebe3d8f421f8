#pragma once

#include <glm/vec2.hpp>
#include <string>

#include "base/affine.h"
#include "base/value.h"
#include "geom/cubic.h"

namespace gradmesh {

/// SVG path data of curves and marks that are given in the units of a mesh.
class PathText {
 public:
  explicit PathText(const Affine& view) : view_(view) {}

  void move(glm::dvec2 to);
  void line(glm::dvec2 to);
  /// Continues the path, which must be at the curve's start, along the curve.
  void curve(const Cubic<Value>& curve);
  void close() { text_ += " Z"; }

  /// Adds a mark around a point; `radius` is in the units of the drawing.
  void circle(glm::dvec2 center, double radius);
  void diamond(glm::dvec2 center, double radius);

  const std::string& text() const { return text_; }

 private:
  void command(char letter);
  void add(glm::dvec2 point);

  Affine view_;
  std::string text_;
};

}  // namespace gradmesh
