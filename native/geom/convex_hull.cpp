#include "geom/convex_hull.h"

#include <algorithm>
#include <utility>

#include "geom/cross.h"

namespace gradmesh {

std::vector<glm::dvec2> convex_hull(std::vector<glm::dvec2> points) {
  std::ranges::sort(points, {}, [](glm::dvec2 p) { return std::pair(p.x, p.y); });
  std::vector<glm::dvec2> hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t base = hull.size();
    for (const glm::dvec2 p : points) {
      while (hull.size() >= base + 2 &&
             cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0)
        hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::ranges::reverse(points);
  }
  return hull;
}

}  // namespace gradmesh
