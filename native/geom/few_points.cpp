#include "geom/few_points.h"

#include <algorithm>
#include <cstddef>
#include <glm/geometric.hpp>
#include <utility>

namespace gradmesh {
namespace {

double distance_to_line(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
  const glm::dvec2 along = b - a;
  const double length = glm::dot(along, along);
  const double t = length > 0 ? glm::dot(p - a, along) / length : 0;
  return glm::distance(p, a + std::clamp(t, 0.0, 1.0) * along);
}

}  // namespace

std::vector<glm::dvec2> with_few_points(const std::vector<glm::dvec2>& polygon, double tolerance) {
  const std::size_t size = polygon.size();
  if (size < 4) return polygon;
  const auto from_first = [&](glm::dvec2 p) { return glm::distance(p, polygon[0]); };
  const std::size_t farthest =
      std::size_t(std::ranges::max_element(polygon, {}, from_first) - polygon.begin());
  std::vector<bool> stays(size, false);
  stays[0] = stays[farthest] = true;
  // Runs of points between two that stay; behind the last one comes the first.
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, farthest}, {farthest, size}};
  while (!open.empty()) {
    const auto [begin, end] = open.back();
    open.pop_back();
    std::size_t most = begin;
    double off = tolerance;
    for (std::size_t i = begin + 1; i < end; ++i) {
      const double away = distance_to_line(polygon[i], polygon[begin], polygon[end % size]);
      if (away <= off) continue;
      most = i;
      off = away;
    }
    if (most == begin) continue;
    stays[most] = true;
    open.push_back({begin, most});
    open.push_back({most, end});
  }
  std::vector<glm::dvec2> few;
  for (std::size_t i = 0; i < size; ++i)
    if (stays[i]) few.push_back(polygon[i]);
  return few;
}

}  // namespace gradmesh
