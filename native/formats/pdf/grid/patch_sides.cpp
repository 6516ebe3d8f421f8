#include "formats/pdf/grid/patch_sides.h"

#include <algorithm>
#include <cmath>

#include "geom/cross.h"

namespace gradmesh {
namespace {

std::array<int, 4> either_way(std::array<int, 4> curve) {
  std::array<int, 4> other = curve;
  std::ranges::reverse(other);
  return std::min(curve, other);
}

bool is_same_color(const glm::dvec4& a, const glm::dvec4& b) {
  // Between the halves of a patch Illustrator's colours differ by up to 2 of 255.
  constexpr double hardly = 2.5 / 255;
  return std::abs(a.r - b.r) <= hardly && std::abs(a.g - b.g) <= hardly &&
         std::abs(a.b - b.b) <= hardly && std::abs(a.a - b.a) <= hardly;
}

}  // namespace

PagePatch laid(const PagePatch& patch, const LaidPatch& lies) {
  const PagePatch turned = patch.turned(std::size_t(lies.first));
  return lies.is_mirrored ? turned.mirrored() : turned;
}

double area_of(const PagePatch& patch, const LaidPatch& lies) {
  const double area = cross(patch.outer[6] - patch.outer[0], patch.outer[9] - patch.outer[3]);
  return lies.is_mirrored ? -area : area;
}

PatchSides::PatchSides(std::vector<PagePatch> patches, double tolerance)
    : patches_(std::move(patches)) {
  WeldedPoints welded(tolerance);
  for (std::size_t n = 0; n < patches_.size(); ++n) {
    Points& points = points_.emplace_back();
    for (std::size_t k = 0; k < points.size(); ++k) {
      points[k] = welded.number(patches_[n].outer[k]);
      patches_[n].outer[k] = welded.point(points[k]);
    }
    for (std::size_t side = 0; side < 4; ++side) {
      const Curve curve = side_of({int(n)}, side);
      // A side that is one point joins nothing.
      if (std::ranges::count(curve, curve[0]) < 4) owners_[either_way(curve)].push_back(int(n));
    }
  }
}

PatchSides::Curve PatchSides::side_of(const LaidPatch& lies, std::size_t side) const {
  const Points& points = points_[std::size_t(lies.patch)];
  Curve curve{};
  for (std::size_t n = 0; n < 4; ++n) {
    const std::size_t at = (3 * side + n) % points.size();
    curve[n] = points[(3 * std::size_t(lies.first) + (lies.is_mirrored ? points.size() - at : at)) %
                      points.size()];
  }
  return curve;
}

std::optional<LaidPatch> PatchSides::beyond(const LaidPatch& here, std::size_t side) const {
  Curve curve = side_of(here, side);
  const auto owners = owners_.find(either_way(curve));
  if (owners == owners_.end() || owners->second.size() != 2) return {};
  const bool is_first = owners->second[0] == here.patch;
  const int other = owners->second[is_first ? 1 : 0];
  if (other == here.patch) return {};
  std::ranges::reverse(curve);
  const std::size_t opposite = (side + 2) % 4;
  for (const bool is_mirrored : {false, true})
    for (int first = 0; first < 4; ++first) {
      const LaidPatch there{other, first, is_mirrored};
      const double areas = area_of(patches_[std::size_t(here.patch)], here) *
                           area_of(patches_[std::size_t(other)], there);
      if (areas >= 0 && side_of(there, opposite) == curve &&
          has_same_colors(here, side, there, opposite))
        return there;
    }
  return {};
}

bool PatchSides::has_same_colors(const LaidPatch& a, std::size_t side_a, const LaidPatch& b,
                                 std::size_t side_b) const {
  const auto color = [this](const LaidPatch& lies, std::size_t corner) {
    const int k = lies.first + int(lies.is_mirrored ? 4 - corner % 4 : corner);
    return patches_[std::size_t(lies.patch)].colors[std::size_t(k % 4)];
  };
  return is_same_color(color(a, side_a), color(b, side_b + 1)) &&
         is_same_color(color(a, side_a + 1), color(b, side_b));
}

}  // namespace gradmesh
