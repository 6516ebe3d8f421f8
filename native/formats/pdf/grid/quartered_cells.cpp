#include "formats/pdf/grid/quartered_cells.h"

#include <array>
#include <optional>

#include "formats/pdf/shading/triangle_fan.h"

namespace gradmesh {
namespace {

std::optional<ShadingTriangle> triangle_of(const ShadingPatch& patch) {
  for (std::size_t n = 1; n < 4; ++n)
    if (patch.side_point(2, n) != patch.side_point(2, 0)) return {};
  return ShadingTriangle{ShadingVertex{patch.outer[0], patch.colors[0]},
                         {patch.outer[3], patch.colors[1]},
                         {patch.outer[6], patch.colors[2]}};
}

ShadingVertex between(const ShadingVertex& a, const ShadingVertex& b) {
  ShadingVertex middle{0.5 * (a.place + b.place), a.color};
  for (std::size_t n = 0; n < a.color.size(); ++n)
    middle.color[n] = 0.5 * (a.color[n] + b.color[n]);
  return middle;
}

std::optional<TriangleFan> fan_at(const std::vector<ShadingPatch>& patches, std::size_t first) {
  std::array<ShadingTriangle, 4> triangles;
  if (first + triangles.size() > patches.size()) return {};
  for (std::size_t n = 0; n < triangles.size(); ++n) {
    auto triangle = triangle_of(patches[first + n]);
    if (!triangle) return {};
    triangles[n] = *std::move(triangle);
  }
  return fan_of(triangles);
}

}  // namespace

std::vector<ShadingPatch> quartered_cells(const std::vector<ShadingPatch>& patches) {
  std::vector<ShadingPatch> all;
  for (std::size_t n = 0; n < patches.size();) {
    const auto fan = fan_at(patches, n);
    if (!fan) {
      all.push_back(patches[n++]);
      continue;
    }
    n += 4;
    for (std::size_t k = 0; k < 4; ++k) {
      const ShadingVertex& corner = fan->corners[k];
      const ShadingVertex next = between(corner, fan->corners[(k + 1) % 4]),
                          last = between(fan->corners[(k + 3) % 4], corner);
      all.push_back(
          straight_patch<Components>({corner.place, next.place, fan->middle.place, last.place},
                                     {corner.color, next.color, fan->middle.color, last.color}));
    }
  }
  return all;
}

}  // namespace gradmesh
