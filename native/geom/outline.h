#pragma once

#include <glm/vec2.hpp>
#include <vector>

namespace gradmesh {

/// Closed polygons; the last point is joined to the first.
using Outline = std::vector<std::vector<glm::dvec2>>;

/// Which points lie inside an outline, as SVG's fill-rule.
enum class FillRule { nonzero, evenodd };

/// What of a mesh is seen: what lies inside an outline in mesh units.
struct VisibleArea {
  Outline outline;
  FillRule rule = FillRule::nonzero;
};

}  // namespace gradmesh
