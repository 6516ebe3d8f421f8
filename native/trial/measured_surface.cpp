#include "trial/measured_surface.h"

#include <algorithm>
#include <string_view>
#include <unordered_set>

#include "metric/detail_errors.h"
#include "metric/local_mean.h"
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

MeasuredSurface::OnGround::OnGround(const Mesh& surface, const Frame& frame, const Metric& metric,
                                    const LocalBound* bound,
                                    const Raster<std::uint8_t, 1>* away_from_outline)
    : image(paint_whole(surface, frame).image),
      map(metric.map(image)),
      sum(gradmesh::sum(map, map.window())) {
  if (away_from_outline) {
    details = Plane(map.window());
    update_detail_errors(map, *away_from_outline, map.window(), details);
  }
  find_errors(bound);
}

MeasuredSurface::OnGround::OnGround(const OnGround& near, const Mesh& surface, const Frame& frame,
                                    Window changed, const Metric& metric, const LocalBound* bound,
                                    const Raster<std::uint8_t, 1>& away_from_outline, double limit)
    : image(near.image), map(near.map), details(near.details) {
  Painting part(changed);
  paint_whole(surface, frame, part);
  copy(part.image, changed, image);
  const auto pixels = double(map.pixels());
  sum = near.sum +
        metric.update_map_in_parallel(near.image, image, changed, map, limit * pixels - near.sum);
  if (sum / pixels > limit) {
    error = {.mean = sum / pixels, .keeps_local_bound = !bound};
    return;
  }
  if (!details.samples.empty())
    update_detail_errors(map, away_from_outline, changed.grown(metric.reach()), details);
  find_errors(bound);
}

void MeasuredSurface::OnGround::find_errors(const LocalBound* bound) {
  error.mean = map.samples.empty() ? 0 : sum / double(map.pixels());
  error.local = largest_local_mean(map);
  error.keeps_local_bound = !bound || bound->holds(map, error.local);
  if (!details.samples.empty()) error.detail = std::ranges::max(details.samples);
}

MeasuredSurface::MeasuredSurface(const Reference& reference, const Mesh& surface,
                                 bool masks_opacity, const LocalBound* bound, bool measures_details)
    : masks_opacity_(masks_opacity),
      patches_(patches_alone(surface)),
      on_white_(surface, masked(reference.frame(), masks_opacity), reference.metric(), bound,
                measures_details ? &reference.away_from_outline() : nullptr) {
  if (const Metric* const metric = reference.metric_on_black())
    on_black_.emplace(surface, on_black(masked(reference.frame(), masks_opacity)), *metric, bound,
                      measures_details ? &reference.away_from_outline() : nullptr);
  find_error();
}

MeasuredSurface::MeasuredSurface(const MeasuredSurface& near, const Reference& reference,
                                 const Mesh& surface, const LocalBound* bound, double limit)
    : masks_opacity_(near.masks_opacity_),
      patches_(patches_alone(surface)),
      on_white_(near.on_white_, surface, masked(reference.frame(), masks_opacity_),
                differs_from(near, reference.frame()), reference.metric(), bound,
                reference.away_from_outline(), limit) {
  if (near.on_black_ && on_white_.error.mean <= limit)
    on_black_.emplace(*near.on_black_, surface, on_black(masked(reference.frame(), masks_opacity_)),
                      differs_from(near, reference.frame()), *reference.metric_on_black(), bound,
                      reference.away_from_outline(), std::numeric_limits<double>::infinity());
  find_error();
}

void MeasuredSurface::find_error() {
  error_ = on_white_.error;
  if (!on_black_) return;
  const FrameError& other = on_black_->error;
  error_.local = std::max(error_.local, other.local);
  error_.detail = std::max(error_.detail, other.detail);
  error_.keeps_local_bound = error_.keeps_local_bound && other.keeps_local_bound;
}

const Plane& MeasuredSurface::details() const {
  return on_black_ && on_black_->error.detail > on_white_.error.detail ? on_black_->details
                                                                       : on_white_.details;
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
