#pragma once

#include <glm/vec2.hpp>
#include <vector>

namespace gradmesh {

/// Closed polygons; the last point is joined to the first.
using Outline = std::vector<std::vector<glm::dvec2>>;

/// Which points lie inside an outline, as SVG's fill-rule.
enum class FillRule { nonzero, evenodd };

struct FilledOutline {
  Outline outline;
  FillRule rule = FillRule::nonzero;
};

/// What of a mesh is seen: what lies, in mesh units, inside of any outline of each of these sets.
struct VisibleArea {
  std::vector<std::vector<FilledOutline>> sets;
};

}  // namespace gradmesh
