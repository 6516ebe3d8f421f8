#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <vector>

#include "mesh/mesh.h"

namespace gradmesh {

/// Colours that change along one straight line, as those of SVG's linearGradient do.
struct LinearColors {
  struct Stop {
    /// The share of the way from `start` to `end`. Two stops at one place are a step.
    double place;
    glm::dvec4 color;
  };

  /// In mesh units.
  glm::dvec2 start{0.0}, end{0.0};
  /// In the order of their places; one if all of the mesh has one colour.
  std::vector<Stop> stops;
};

/// Returns the colours of a mesh whose picture is that of such colours, with one opacity, where the
/// mesh is; nothing if it is not. Control points may be `tolerance` mesh units away from where they
/// would have to be, colours are compared in 8 bits.
std::optional<LinearColors> linear_colors(const Mesh& mesh, double tolerance);

}  // namespace gradmesh
