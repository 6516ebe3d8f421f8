#include "app/pages/page_tiles.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "app/pages/page_shapes.h"
#include "formats/pdf/grid/welded_points.h"
#include "formats/svg/values/path.h"

namespace gradmesh {
namespace {

/// A tile has few patches, a surface many tiles.
constexpr std::size_t patches_of_tile = 4, parts_of_tile = 8, fewest_tiles = 8;
/// In points: what rounds the corners of tiles.
constexpr double point_tolerance = 0.02;
/// Paths around a tile are short.
constexpr std::size_t steps_around_tile = 64;

bool is_tile(const ShadingOnPage& shading) {
  const PaintedShading& painted = shading.painted;
  return shading.shown.shading.patches.size() <= patches_of_tile &&
         shading.shown.patches.size() <= parts_of_tile && !painted.mask && !painted.stroke;
}

bool is_painted_alike(const PaintedShading& a, const PaintedShading& b) {
  return a.opacity == b.opacity && a.blend_mode == b.blend_mode && a.group == b.group;
}

bool is_same(const Clips& a, const Clips& b) {
  return std::ranges::equal(a, b, [](const auto& x, const auto& y) { return x == y || *x == *y; });
}

/// Returns true if a clip path hides nothing of patches: places all over them lie inside. Those
/// at their sides are left out, since the path may run there, and either may be rounded.
bool hides_nothing(const PagePath& path, const std::vector<PagePatch>& patches) {
  if (path.steps.size() > steps_around_tile) return false;
  const auto outline = path_outline(path_data(path));
  if (!outline) return false;
  const FilledOutline area{*outline, path.rule};
  for (const PagePatch& page : patches) {
    const Patch patch = mesh_patch(page);
    for (const double u : {0.1, 0.3, 0.5, 0.7, 0.9})
      for (const double v : {0.1, 0.3, 0.5, 0.7, 0.9})
        if (!contains(area, pixels_per_point * patch.at(u, v).position)) return false;
  }
  return true;
}

/// Returns the clip paths of a shading without the innermost one, if that hides nothing of it.
Clips clips_around(const ShadingOnPage& shading) {
  Clips clips = shading.painted.clips;
  if (!clips.empty() && hides_nothing(*clips.back(), shading.shown.patches)) clips.pop_back();
  return clips;
}

}  // namespace

bool PageTiles::take(ShadingOnPage& next) {
  const bool is_one = is_tile(next);
  Clips around = is_one ? clips_around(next) : Clips();
  if (shadings_.empty()) {
    around_ = std::move(around);
  } else {
    const PaintedShading& first = shadings_.front().painted;
    const bool same_clips = has_same_clips_ && is_same(first.clips, next.painted.clips);
    const bool same_around = has_same_around_ && is_same(around_, around);
    if (!is_one || !is_tile(shadings_.front()) || !is_painted_alike(first, next.painted) ||
        (!same_clips && !same_around))
      return false;
    has_same_clips_ = same_clips;
    has_same_around_ = same_around;
  }
  shadings_.push_back(std::move(next));
  return true;
}

std::vector<PageTiles::Span> PageTiles::surfaces() const {
  WeldedPoints points(point_tolerance);
  // For each corner the first tile that has it, and for each tile the last that shares one.
  std::unordered_map<int, std::size_t> first_with;
  std::vector<std::size_t> reach(shadings_.size());
  for (std::size_t n = 0; n < shadings_.size(); ++n)
    for (const PagePatch& patch : shadings_[n].shown.patches)
      for (std::size_t k = 0; k < 4; ++k)
        reach[first_with.try_emplace(points.number(patch.outer[3 * k]), n).first->second] = n;
  std::vector<Span> spans;
  std::size_t begin = 0, last = 0;
  for (std::size_t n = 0; n < shadings_.size(); ++n) {
    last = std::max(last, reach[n]);
    if (last > n) continue;
    spans.push_back({begin, n + 1});
    begin = last = n + 1;
  }
  return spans;
}

std::optional<ShadingOnPage> PageTiles::surface(Span span) const {
  if (span.end - span.begin < fewest_tiles) return {};
  const ShadingOnPage& first = shadings_[span.begin];
  ShadingOnPage surface{first.number,
                        first.painted,
                        {{first.shown.shading.type, {ColorSpace::device_rgb(), {}}, {}}, {}, {}}};
  if (!has_same_clips_) surface.painted.clips = around_;
  for (std::size_t n = span.begin; n < span.end; ++n)
    for (const PagePatch& patch : shadings_[n].shown.patches) {
      surface.shown.patches.push_back(patch);
      ShadingPatch& own = surface.shown.shading.patches.emplace_back();
      own.outer = patch.outer;
      own.inner = patch.inner;
      for (std::size_t k = 0; k < 4; ++k)
        own.colors[k] = {patch.colors[k].r, patch.colors[k].g, patch.colors[k].b};
    }
  return surface;
}

}  // namespace gradmesh
