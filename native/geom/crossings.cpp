#include "geom/crossings.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/clamped_int.h"

namespace gradmesh {

std::vector<std::vector<Crossing>> crossings(const Outline& outline, int a_row, double offset,
                                             int lines) {
  std::vector<std::vector<Crossing>> found{std::size_t(lines)};
  for (const std::vector<glm::dvec2>& polygon : outline)
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      glm::dvec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
      const int winding = a.y < b.y ? 1 : -1;
      if (winding < 0) std::swap(a, b);
      const int end = clamped_int(std::ceil(b.y * a_row - offset), 0, lines);
      for (int k = clamped_int(std::ceil(a.y * a_row - offset), 0, lines); k < end; ++k) {
        const double share = ((k + offset) / a_row - a.y) / (b.y - a.y);
        found[std::size_t(k)].push_back({std::lerp(a.x, b.x, share), winding});
      }
    }
  for (std::vector<Crossing>& line : found) std::ranges::sort(line, {}, &Crossing::x);
  return found;
}

}  // namespace gradmesh
