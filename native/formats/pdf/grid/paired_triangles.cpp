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

/// The patch with straight sides between these corners.
ShadingPatch straight_patch(const std::array<TriangleCorner, 4>& corners) {
  ShadingPatch patch;
  for (std::size_t k = 0; k < 4; ++k) {
    const glm::dvec2 from = corners[k].place, to = corners[(k + 1) % 4].place;
    for (std::size_t n = 0; n < 3; ++n) patch.outer[3 * k + n] = from + double(n) / 3 * (to - from);
    patch.colors[k] = *corners[k].color;
    patch.inner[k] =
        (4.0 * from + 2.0 * to + corners[(k + 2) % 4].place + 2.0 * corners[(k + 3) % 4].place) /
        9.0;
  }
  return patch;
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
        if (is_convex(corners)) return straight_patch(corners);
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
