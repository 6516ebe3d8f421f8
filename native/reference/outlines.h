#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "mesh/mesh.h"
#include "raster/frame.h"

namespace gradmesh {

/// Returns true if the colour jumps across the curve of a curve side, or if the curve is on the
/// boundary: such a curve is seen as an outline.
bool is_outline(const Mesh& mesh, Halfedge side);

/// Returns a cubic curve in pixels of the frame.
Cubic<glm::dvec2> in_pixels(const Cubic<Value>& curve, const Frame& frame);

/// A point of an outline, in pixels, and the unit vector across.
struct OutlinePoint {
  glm::dvec2 place, normal;
};

/// Points along the outlines of a mesh, a pixel apart, found by their places.
class OutlinePoints {
 public:
  /// There are none.
  OutlinePoints() = default;
  OutlinePoints(const Mesh& mesh, const Frame& frame);

  /// Returns the closest point of an outline; nothing where there is none within a few pixels.
  std::optional<OutlinePoint> closest(glm::dvec2 place) const;

 private:
  struct Cell {
    int column, row;
  };

  void add(const Cubic<glm::dvec2>& outline);
  Cell cell_of(glm::dvec2 place) const;

  int columns_ = 0, rows_ = 0;
  /// By the square cells of a grid over the frame.
  std::vector<std::vector<OutlinePoint>> cells_;
};

}  // namespace gradmesh
