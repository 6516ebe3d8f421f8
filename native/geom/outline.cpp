#include "geom/outline.h"

#include <utility>

namespace gradmesh {

Outline rectangle(glm::dvec2 low, glm::dvec2 high) {
  return {{low, {high.x, low.y}, high, {low.x, high.y}}};
}

Outline mapped(Outline outline, const Affine& map) {
  for (std::vector<glm::dvec2>& polygon : outline)
    for (glm::dvec2& p : polygon) p = map.point(p);
  return outline;
}

Box bounding_box(const Outline& outline) {
  Box box;
  for (const std::vector<glm::dvec2>& polygon : outline)
    for (const glm::dvec2 p : polygon) box.add(p);
  return box;
}

FilledOutline mapped(FilledOutline area, const Affine& map) {
  area.outline = mapped(std::move(area.outline), map);
  return area;
}

bool contains(const FilledOutline& area, glm::dvec2 place) {
  int winding = 0, crossings = 0;
  for (const std::vector<glm::dvec2>& polygon : area.outline)
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
      const glm::dvec2 a = polygon[j], b = polygon[i];
      if ((a.y > place.y) == (b.y > place.y)) continue;
      if (place.x >= a.x + (b.x - a.x) * (place.y - a.y) / (b.y - a.y)) continue;
      winding += b.y > a.y ? 1 : -1;
      ++crossings;
    }
  return area.rule == FillRule::nonzero ? winding != 0 : crossings % 2 == 1;
}

}  // namespace gradmesh
