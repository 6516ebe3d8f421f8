#pragma once

#include <glm/vec3.hpp>

#include "geom/outline.h"

namespace gradmesh {

/// An area of one colour.
struct FlatArea {
  FilledOutline area;
  /// (r, g, b), 0..1, sRGB.
  glm::dvec3 color;
};

}  // namespace gradmesh
