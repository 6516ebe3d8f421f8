#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "base/affine.h"
#include "geom/box.h"

namespace gradmesh {

/// Closed polygons; the last point is joined to the first.
using Outline = std::vector<std::vector<glm::dvec2>>;

/// Returns the outline of the rectangle with these corners.
Outline rectangle(glm::dvec2 low, glm::dvec2 high);

/// Returns the outline with all its points mapped.
Outline mapped(Outline outline, const Affine& map);

/// Returns the box around an outline.
Box bounding_box(const Outline& outline);

/// SVG's fill-rule: which points lie inside an outline.
enum class FillRule { nonzero, evenodd };

struct FilledOutline {
  Outline outline;
  FillRule rule = FillRule::nonzero;
};

/// Returns the area with all its points mapped.
FilledOutline mapped(FilledOutline area, const Affine& map);

/// Returns true if a place lies inside.
bool contains(const FilledOutline& area, glm::dvec2 place);

/// The part of a mesh that is seen, in mesh units: the points that lie, for each of these sets,
/// inside of at least one outline of the set.
struct VisibleArea {
  std::vector<std::vector<FilledOutline>> sets;
};

}  // namespace gradmesh
