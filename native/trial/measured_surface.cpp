#include "trial/measured_surface.h"

#include <algorithm>
#include <string_view>
#include <unordered_set>

#include "raster/painting.h"

namespace gradmesh {
namespace {

static_assert(sizeof(Patch) == 16 * 6 * sizeof(double), "patches are compared by their bytes");

std::string_view bytes_of(const Patch& patch) {
  return {reinterpret_cast<const char*>(&patch), sizeof patch};
}

std::vector<Patch> patches_alone(const Mesh& surface) {
  std::vector<Patch> patches;
  if (surface.is_smooth()) return patches;
  for (const Point p : surface.points())
    if (surface[p].is_junction()) return patches;
  for (const Face f : surface.faces()) patches.push_back(surface.patch(f));
  return patches;
}

Measures on_white(const Reference& reference, bool masks_opacity, const LocalBound* bound,
                  bool measures_details) {
  Measures measures{reference.frame(), reference.metric(), bound};
  measures.frame.masked_opacity = masks_opacity;
  if (measures_details) measures.away_from_outline = &reference.away_from_outline();
  return measures;
}

/// Returns how that is measured on black which `white` tells how to measure on white.
Measures on_black(const Measures& white, const Metric& metric) {
  return {on_black(white.frame), metric, white.bound, white.away_from_outline};
}

}  // namespace

MeasuredSurface::MeasuredSurface(const Reference& reference, const Mesh& surface,
                                 bool masks_opacity, const LocalBound* bound, bool measures_details)
    : masks_opacity_(masks_opacity), patches_(patches_alone(surface)) {
  const Measures white = on_white(reference, masks_opacity, bound, measures_details);
  on_white_.emplace(surface, white);
  if (const Metric* const metric = reference.metric_on_black())
    on_black_.emplace(surface, on_black(white, *metric));
  find_error();
}

MeasuredSurface::MeasuredSurface(const MeasuredSurface& near, const Reference& reference,
                                 const Mesh& surface, const LocalBound* bound, double limit)
    : masks_opacity_(near.masks_opacity_), patches_(patches_alone(surface)) {
  const Measures white = on_white(reference, masks_opacity_, bound, true);
  const Window changed = differs_from(near, white.frame);
  on_white_.emplace(*near.on_white_, surface, changed, white, limit);
  if (near.on_black_ && on_white_->error().mean <= limit)
    on_black_.emplace(*near.on_black_, surface, changed,
                      on_black(white, *reference.metric_on_black()),
                      std::numeric_limits<double>::infinity());
  find_error();
}

void MeasuredSurface::find_error() {
  error_ = on_white_->error();
  if (!on_black_) return;
  const FrameError& other = on_black_->error();
  error_.local = std::max(error_.local, other.local);
  error_.detail = std::max(error_.detail, other.detail);
  error_.keeps_local_bound = error_.keeps_local_bound && other.keeps_local_bound;
}

const Plane& MeasuredSurface::details() const {
  const bool is_worse_on_black = on_black_ && on_black_->error().detail > on_white_->error().detail;
  return (is_worse_on_black ? on_black_ : on_white_)->whole().details;
}

/// Returns the pixels of the patches that only one of the two surfaces has.
Window MeasuredSurface::differs_from(const MeasuredSurface& near, const Frame& frame) const {
  if (patches_.empty() || near.patches_.empty()) return frame.window();
  Window changed;
  const auto add_others = [&](const std::vector<Patch>& from, const std::vector<Patch>& than) {
    std::unordered_set<std::string_view> known;
    for (const Patch& patch : than) known.insert(bytes_of(patch));
    for (const Patch& patch : from)
      if (!known.contains(bytes_of(patch))) changed = changed.united(pixel_bounds(patch, frame));
  };
  add_others(patches_, near.patches_);
  add_others(near.patches_, patches_);
  return changed.clipped(frame.window());
}

}  // namespace gradmesh
