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

Frame masked(Frame frame, bool masks_opacity) {
  frame.masked_opacity = masks_opacity;
  return frame;
}

}  // namespace

MeasuredSurface::MeasuredSurface(const Reference& reference, const Mesh& surface,
                                 bool masks_opacity, const LocalBound* bound, bool measures_details)
    : masks_opacity_(masks_opacity),
      patches_(patches_alone(surface)),
      on_white_(surface, {masked(reference.frame(), masks_opacity), reference.metric(), bound,
                          measures_details ? &reference.away_from_outline() : nullptr}) {
  if (const Metric* const metric = reference.metric_on_black())
    on_black_.emplace(surface,
                      Measures{on_black(masked(reference.frame(), masks_opacity)), *metric, bound,
                               measures_details ? &reference.away_from_outline() : nullptr});
  find_error();
}

MeasuredSurface::MeasuredSurface(const MeasuredSurface& near, const Reference& reference,
                                 const Mesh& surface, const LocalBound* bound, double limit)
    : masks_opacity_(near.masks_opacity_),
      patches_(patches_alone(surface)),
      on_white_(near.on_white_, surface, differs_from(near, reference.frame()),
                {masked(reference.frame(), masks_opacity_), reference.metric(), bound,
                 &reference.away_from_outline()},
                limit) {
  if (near.on_black_ && on_white_.error().mean <= limit)
    on_black_.emplace(*near.on_black_, surface, differs_from(near, reference.frame()),
                      Measures{on_black(masked(reference.frame(), masks_opacity_)),
                               *reference.metric_on_black(), bound, &reference.away_from_outline()},
                      std::numeric_limits<double>::infinity());
  find_error();
}

void MeasuredSurface::find_error() {
  error_ = on_white_.error();
  if (!on_black_) return;
  const FrameError& other = on_black_->error();
  error_.local = std::max(error_.local, other.local);
  error_.detail = std::max(error_.detail, other.detail);
  error_.keeps_local_bound = error_.keeps_local_bound && other.keeps_local_bound;
}

const Plane& MeasuredSurface::details() const {
  const bool is_worse_on_black = on_black_ && on_black_->error().detail > on_white_.error().detail;
  return (is_worse_on_black ? *on_black_ : on_white_).whole().details;
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
