#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "mesh/mesh.h"
#include "raster/frame.h"
#include "raster/painting.h"

namespace gradmesh {

/// Returns true if the colour jumps across the curve of a curve side, or if the curve is on the
/// boundary: such a curve is seen as an outline.
bool is_outline(const Mesh& mesh, Halfedge side);

/// What a mesh is fitted to: the picture of the original, and the outlines in it. Places are in
/// pixels of the frame.
class FitTarget {
 public:
  FitTarget(const Mesh& original, const Frame& frame);

  const Frame& frame() const { return frame_; }

  /// Returns the picture's colour, 0..1, interpolated between the centres of pixels; nothing where
  /// the original does not cover the nearest of them.
  std::optional<glm::dvec3> color_at(glm::dvec2 place) const;

  /// A point of an outline, and the unit vector across.
  struct OutlinePoint {
    glm::dvec2 place, normal;
  };
  /// Returns the closest point of an outline; nothing where there is none within a few pixels.
  std::optional<OutlinePoint> outline_near(glm::dvec2 place) const;

  /// Returns true if the pixel of this place is hidden.
  bool is_hidden(glm::dvec2 place) const;

 private:
  void add_outline(const Cubic<Value>& curve);
  std::vector<OutlinePoint>* cell_at(glm::dvec2 place);

  const Frame frame_;
  Painting painting_;
  /// Points along the outlines, a pixel apart, by the square cells of a grid.
  int columns_ = 0, rows_ = 0;
  std::vector<std::vector<OutlinePoint>> cells_;
};

/// Returns a cubic curve in pixels of the frame.
Cubic<glm::dvec2> in_pixels(const Cubic<Value>& curve, const Frame& frame);

}  // namespace gradmesh
