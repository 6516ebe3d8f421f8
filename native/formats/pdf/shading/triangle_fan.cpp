#include "formats/pdf/shading/triangle_fan.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

namespace gradmesh {
namespace {

using Corner = const ShadingVertex*;
using Side = std::array<Corner, 2>;

bool has(const ShadingTriangle& triangle, const ShadingVertex& vertex) {
  return std::ranges::find(triangle, vertex) != triangle.end();
}

/// Returns the side of a triangle that is opposite to one of its corners.
Side side_opposite(const ShadingTriangle& triangle, const ShadingVertex& corner) {
  const auto n = std::size_t(std::ranges::find(triangle, corner) - triangle.begin());
  return {&triangle[(n + 1) % 3], &triangle[(n + 2) % 3]};
}

/// Returns where a walk along sides, each once, comes by; nothing if it does not lead around.
std::optional<std::array<Corner, 4>> ring_of(std::array<Side, 4> sides) {
  std::array<Corner, 4> ring{sides[0][0], sides[0][1]};
  for (std::size_t n = 1; n < 4; ++n) {
    const auto next = std::find_if(sides.begin() + n, sides.end(), [&](const Side& side) {
      return *side[0] == *ring[n] || *side[1] == *ring[n];
    });
    if (next == sides.end()) return {};
    const Corner to = *(*next)[0] == *ring[n] ? (*next)[1] : (*next)[0];
    std::iter_swap(sides.begin() + n, next);
    if (n < 3) ring[n + 1] = to;
    if (n == 3 && *to != *ring[0]) return {};
  }
  return ring;
}

}  // namespace

std::optional<TriangleFan> fan_of(std::span<const ShadingTriangle, 4> triangles) {
  for (const ShadingVertex& middle : triangles[0]) {
    if (!std::ranges::all_of(triangles, [&](const auto& each) { return has(each, middle); }))
      continue;
    std::array<Side, 4> sides{};
    for (std::size_t n = 0; n < 4; ++n) sides[n] = side_opposite(triangles[n], middle);
    if (const auto ring = ring_of(sides))
      return TriangleFan{{*(*ring)[0], *(*ring)[1], *(*ring)[2], *(*ring)[3]}, middle};
  }
  return {};
}

bool is_bilinear(const TriangleFan& fan, const std::vector<Packing::Range>& components) {
  constexpr double levels = 4.0 / 255;
  const auto& c = fan.corners;
  const glm::dvec2 mean = 0.25 * (c[0].place + c[1].place + c[2].place + c[3].place);
  const double size =
      std::max(glm::distance(c[0].place, c[2].place), glm::distance(c[1].place, c[3].place));
  if (glm::distance(mean, fan.middle.place) > 0.01 * size) return false;
  for (std::size_t n = 0; n < components.size(); ++n) {
    const double range = std::abs(components[n][1] - components[n][0]);
    const double sum = c[0].color[n] + c[1].color[n] + c[2].color[n] + c[3].color[n];
    // Along a diagonal the patch is a parabola through the triangles' three points, and farthest
    // from their chords, by a sixteenth of its bend, in the middle of each.
    const double bend = c[0].color[n] - c[1].color[n] + c[2].color[n] - c[3].color[n];
    if (std::abs(fan.middle.color[n] - 0.25 * sum) > levels * range ||
        std::abs(bend) / 16 > levels * range)
      return false;
  }
  return true;
}

}  // namespace gradmesh
