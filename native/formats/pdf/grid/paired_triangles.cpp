#include "formats/pdf/grid/paired_triangles.h"

#include <algorithm>
#include <array>
#include <optional>

#include "geom/cross.h"

namespace gradmesh {
namespace {

struct TriangleCorner {
  glm::dvec2 place;
  const Components* color;

  bool operator==(const TriangleCorner& other) const {
    return place == other.place && *color == *other.color;
  }
};

TriangleCorner corner_of(const ShadingPatch& patch, std::size_t k) {
  return {patch.outer[3 * (k % 3)], &patch.colors[k % 3]};
}

bool is_triangle(const ShadingPatch& patch) {
  for (std::size_t n = 1; n < 4; ++n)
    if (patch.side_point(2, n) != patch.side_point(2, 0)) return false;
  return true;
}

bool is_convex(const std::array<TriangleCorner, 4>& corners) {
  double least = 0, most = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const glm::dvec2 at = corners[(k + 1) % 4].place;
    const double turn = cross(at - corners[k].place, corners[(k + 2) % 4].place - at);
    least = std::min(least, turn);
    most = std::max(most, turn);
  }
  return least == 0 || most == 0;
}

/// Returns the patch that two triangles make; nothing if they share no side.
std::optional<ShadingPatch> pair_of(const ShadingPatch& a, const ShadingPatch& b) {
  if (!is_triangle(a) || !is_triangle(b)) return {};
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t n = 0; n < 3; ++n)
      for (const std::size_t next : {1U, 2U}) {
        // Side k + 1 to k + 2 of the first, either way along a side of the other.
        if (corner_of(a, k + 1) != corner_of(b, n + next) ||
            corner_of(a, k + 2) != corner_of(b, n + 3 - next))
          continue;
        const std::array<TriangleCorner, 4> corners{corner_of(a, k), corner_of(a, k + 1),
                                                    corner_of(b, n), corner_of(a, k + 2)};
        if (!is_convex(corners)) continue;
        std::array<glm::dvec2, 4> places{};
        std::array<Components, 4> colors;
        for (std::size_t corner = 0; corner < 4; ++corner) {
          places[corner] = corners[corner].place;
          colors[corner] = *corners[corner].color;
        }
        return straight_patch(places, colors);
      }
  return {};
}

}  // namespace

std::vector<ShadingPatch> paired_triangles(const std::vector<ShadingPatch>& patches) {
  std::vector<ShadingPatch> pairs;
  for (std::size_t n = 0; n < patches.size(); ++n) {
    if (n + 1 < patches.size())
      if (auto pair = pair_of(patches[n], patches[n + 1])) {
        pairs.push_back(*std::move(pair));
        ++n;
        continue;
      }
    pairs.push_back(patches[n]);
  }
  return pairs;
}

}  // namespace gradmesh
