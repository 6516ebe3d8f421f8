#include "trial/measured_ground.h"

#include <utility>

#include "metric/detail_errors.h"
#include "metric/local_mean.h"
#include "raster/painting.h"

namespace gradmesh {
namespace {

template <class Sample, int channels>
Raster<Sample, channels> part_of(const Raster<Sample, channels>& whole, Window window) {
  Raster<Sample, channels> part(window);
  copy(whole, window, part);
  return part;
}

template <class Sample, int channels>
void paste(const Raster<Sample, channels>& part, Raster<Sample, channels>& whole) {
  copy(part, part.window(), whole);
}

/// Returns what has changed, painted, with enough around it for the metric.
Image image_near(const Image& near, const Mesh& surface, Window changed, const Measures& by) {
  Painting painting(changed);
  paint_whole(surface, by.frame, painting);
  Image image = part_of(near, changed.grown(2 * by.metric.reach()).clipped(near.window()));
  paste(painting.image, image);
  return image;
}

/// What depends on a part of the metric's map: blocks of local means, with the pixels of their
/// windows, and blocks of errors of details.
struct Dependent {
  Window means, pixels_of_means, details;

  Dependent(Window changed, const MeasuredGround::Maps& near) {
    constexpr int more = local_side - 1;
    means = near.local_means.whole_blocks(
        {changed.x0 - more, changed.y0 - more, changed.x1, changed.y1});
    pixels_of_means =
        Window{means.x0, means.y0, means.x1 + more, means.y1 + more}.clipped(near.map.window());
    details = near.largest_details.whole_blocks(changed.grown(detail_side));
  }
};

}  // namespace

MeasuredGround::MeasuredGround(const Mesh& surface, const Measures& by) {
  auto maps = std::make_shared<Maps>();
  maps->image = paint_whole(surface, by.frame).image;
  maps->map = by.metric.map(maps->image);
  const Window frame = maps->map.window();
  maps->sum = sum(maps->map, frame);
  maps->local_means = BlockMaxima(local_mean_places(frame));
  add_local_means(maps->map, maps->local_means);
  if (by.away_from_outline) {
    maps->details = Plane(frame);
    update_detail_errors(maps->map, *by.away_from_outline, frame, maps->details);
    maps->largest_details = BlockMaxima(frame);
    maps->largest_details.add(maps->details);
  }
  maps_ = std::move(maps);
  find_errors(by);
}

MeasuredGround::MeasuredGround(const MeasuredGround& near, const Mesh& surface, Window changed,
                               const Measures& by, double limit)
    : error_(near.error_), maps_(near.shared_whole()) {
  if (changed.empty()) return;
  near_ = maps_;
  const Window frame = near_->map.window();
  const Window measured = changed.grown(by.metric.reach()).clipped(frame);
  const Dependent dependent(measured, *near_);
  const Window around =
      measured.grown(detail_side).united(dependent.pixels_of_means).clipped(frame);
  const auto maps =
      std::make_shared<Maps>(Maps{.image = image_near(near_->image, surface, changed, by),
                                  .map = part_of(near_->map, around),
                                  .details = part_of(near_->details, dependent.details),
                                  .local_means = near_->local_means,
                                  .largest_details = near_->largest_details});
  maps_ = maps;
  const auto pixels = double(near_->map.pixels());
  maps->sum = near_->sum + by.metric.update_map_in_parallel(near_->image, maps->image, changed,
                                                            maps->map, limit * pixels - near_->sum);
  if (maps->sum / pixels > limit) {
    error_ = {.mean = maps->sum / pixels, .keeps_local_bound = !by.bound};
    return;
  }
  maps->local_means.clear(dependent.means);
  add_local_means(part_of(maps->map, dependent.pixels_of_means), maps->local_means);
  if (!dependent.details.empty()) {
    update_detail_errors(maps->map, *by.away_from_outline, measured, maps->details);
    maps->largest_details.clear(dependent.details);
    maps->largest_details.add(maps->details);
  }
  find_errors(by);
}

const std::shared_ptr<const MeasuredGround::Maps>& MeasuredGround::shared_whole() const {
  std::call_once(is_whole_, [this] {
    if (!near_) return;
    auto whole = std::make_shared<Maps>(*near_);
    paste(maps_->image, whole->image);
    paste(maps_->map, whole->map);
    paste(maps_->details, whole->details);
    whole->sum = maps_->sum;
    whole->local_means = maps_->local_means;
    whole->largest_details = maps_->largest_details;
    maps_ = std::move(whole);
    near_.reset();
  });
  return maps_;
}

void MeasuredGround::find_errors(const Measures& by) {
  const std::size_t pixels = by.frame.window().empty() ? 0 : by.metric.reference().pixels();
  error_.mean = pixels == 0 ? 0 : maps_->sum / double(pixels);
  error_.local = maps_->local_means.largest();
  error_.detail = maps_->largest_details.largest();
  error_.keeps_local_bound = !by.bound || by.bound->holds(error_.local, [&]() -> const Plane& {
    return shared_whole()->map;
  });
}

}  // namespace gradmesh
