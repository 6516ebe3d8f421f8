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

MeasuredSurface::MeasuredSurface(const Reference& reference, const Mesh& surface,
                                 bool masks_opacity, const LocalBound* bound, bool measures_details)
    : masks_opacity_(masks_opacity),
      patches_(patches_alone(surface)),
      image_(paint_whole(surface, masked(reference.frame(), masks_opacity)).image),
      map_(reference.metric().map(image_)),
      sum_(sum(map_, map_.window())) {
  find_errors(bound);
  if (!measures_details) return;
  details_ = Plane(map_.window());
  update_detail_errors(map_, reference.away_from_outline(), map_.window(), details_);
  find_detail();
}

MeasuredSurface::MeasuredSurface(const MeasuredSurface& near, const Reference& reference,
                                 const Mesh& surface, const LocalBound* bound, double limit)
    : masks_opacity_(near.masks_opacity_), patches_(patches_alone(surface)) {
  const Frame frame = masked(reference.frame(), masks_opacity_);
  const Window changed = differs_from(near, frame);
  Painting part(changed);
  paint_whole(surface, frame, part);
  image_ = near.image_;
  copy(part.image, changed, image_);
  map_ = near.map_;
  const auto pixels = double(map_.pixels());
  sum_ = near.sum_ + reference.metric().update_map(near.image_, image_, changed, map_,
                                                   limit * pixels - near.sum_);
  details_ = near.details_;
  if (sum_ / pixels > limit) {
    error_ = {.mean = sum_ / pixels, .keeps_local_bound = !bound};
    return;
  }
  find_errors(bound);
  if (details_.samples.empty()) return;
  update_detail_errors(map_, reference.away_from_outline(),
                       changed.grown(reference.metric().reach()), details_);
  find_detail();
}

void MeasuredSurface::find_detail() {
  const auto largest = std::ranges::max_element(details_.samples);
  if (largest != details_.samples.end()) error_.detail = *largest;
}

void MeasuredSurface::find_errors(const LocalBound* bound) {
  error_.mean = map_.samples.empty() ? 0 : sum_ / double(map_.pixels());
  error_.local = largest_local_mean(map_);
  error_.keeps_local_bound = !bound || bound->holds(map_, error_.local);
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
