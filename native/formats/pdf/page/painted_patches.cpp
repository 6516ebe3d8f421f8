#include "formats/pdf/page/painted_patches.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/error.h"

namespace gradmesh {
namespace {

/// Returns the luminosity of a colour (ISO 32000-1, 11.5.3).
double luminosity(const glm::dvec3& srgb) { return 0.3 * srgb.r + 0.59 * srgb.g + 0.11 * srgb.b; }

bool has_same_points(const ShadingPatch& a, const ShadingPatch& b) {
  // In points: what no page shows, and more than what rounds coordinates.
  constexpr double tolerance = 0.01;
  const auto is_close = [](const glm::dvec2& x, const glm::dvec2& y) {
    return std::abs(x.x - y.x) <= tolerance && std::abs(x.y - y.y) <= tolerance;
  };
  return std::ranges::equal(a.outer, b.outer, is_close) &&
         std::ranges::equal(a.inner, b.inner, is_close);
}

/// What a mask does to patches.
struct Masked {
  std::vector<CornerOpacities> opacities;
  /// Beyond these they are not seen.
  Clips clips;
};

/// Returns what one shading of a mask does to patches, if it has the same patches.
std::optional<Masked> masked_by(const PaintedShading& mask, const Affine& from_page,
                                const std::vector<ShadingPatch>& patches, KeptShadings& kept) try {
  const auto unplaced = kept.read(mask);
  // Those that lie beyond any page are not among `patches`.
  if (mask.mask || mask.group || unplaced->patches.size() < patches.size()) return {};
  const PageShading read = placed(*unplaced, from_page * mask.to_page);
  if (!std::ranges::equal(read.patches, patches, has_same_points)) return {};
  std::vector<CornerOpacities> opacities;
  for (const ShadingPatch& patch : read.patches) {
    CornerOpacities& corners = opacities.emplace_back();
    for (std::size_t k = 0; k < 4; ++k)
      corners[k] = mask.opacity * luminosity(read.colors.srgb(patch.colors[k]));
  }
  return Masked{std::move(opacities), mask.clips};
} catch (const InputError&) {
  return {};
}

/// Returns what a mask does to patches, if one of its shadings has the same patches, as in the
/// documents of Inkscape (cairo).
std::optional<Masked> masked_by(const std::vector<PaintedShading>& mask, const Affine& from_page,
                                const std::vector<ShadingPatch>& patches, KeptShadings& kept) {
  // A stranger's mask of thousands, on each of thousands of shadings, would take hours.
  constexpr std::size_t most_shadings = 16;
  if (mask.size() > most_shadings) return {};
  // Of two the later one lies on top.
  for (auto each = mask.rbegin(); each != mask.rend(); ++each)
    if (auto masked = masked_by(*each, from_page, patches, kept)) return masked;
  return {};
}

}  // namespace

PaintedPatches painted_patches(const PaintedShading& painted, KeptShadings& kept) {
  const Affine from_page = painted.stroke ? painted.stroke->pen.inverse() : Affine();
  PaintedPatches made{placed(*kept.read(painted), from_page * painted.to_page), {}, {}};
  if (!made.shading.colors.paints()) throw InputError("its colorant is None, which paints nothing");
  const std::vector<ShadingPatch>& patches = made.shading.patches;
  auto masked = painted.mask ? masked_by(*painted.mask, from_page, patches, kept) : std::nullopt;
  made.mask_left_out = painted.mask && !masked;
  if (masked) made.mask_clips = std::move(masked->clips);
  made.opacities = masked
                       ? std::move(masked->opacities)
                       : std::vector<CornerOpacities>(patches.size(), CornerOpacities{1, 1, 1, 1});
  for (CornerOpacities& corners : made.opacities)
    for (double& opacity : corners) opacity *= painted.opacity;
  made.patches = in_srgb(patches, made.shading.colors, made.opacities);
  return made;
}

}  // namespace gradmesh
