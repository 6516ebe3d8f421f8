#include "metric/local_metric.h"

#include <stdexcept>
#include <vector>

#include "base/parallel.h"
#include "metric/differences.h"

namespace gradmesh {
namespace {

template <class Raster>
bool covers(const Raster& raster, Window window) {
  return window.clipped(raster.window()) == window;
}

}  // namespace

void for_each_strip(Window window, const std::function<void(Window)>& body) {
  constexpr int largest_height = 64;
  const int height = window.height(), count = (height + largest_height - 1) / largest_height;
  parallel_for(count, [&](std::size_t i) {
    body({window.x0, window.y0 + height * int(i) / count, window.x1,
          window.y0 + height * int(i + 1) / count});
  });
}

void LocalMetric::score_near_differences(const Image& test, Window window, Plane& map) const {
  // Kept from call to call, as there may be hundreds of thousands.
  static thread_local std::vector<Window> tiles;
  tiles.clear();
  append_tiles_near_differences(reference_, test, around(window, reach_), window, reach_, tiles);
  fill(map, window, 0.0F);
  for (const Window& tile : tiles) score(test, tile, map);
}

void LocalMetric::fill_map(const Image& test, Window window, Plane& map) const {
  if (test.window() != reference_.window() || map.window() != reference_.window()) {
    throw std::invalid_argument("The images that a metric compares must have the same size.");
  }
  const Window inside = window.clipped(reference_.window());
  for_each_strip(inside, [&](Window strip) { score_near_differences(test, strip, map); });
}

double LocalMetric::update_map(const Image& before, const Image& test, Window changed, Plane& map,
                               double limit) const {
  changed = around(changed, 0);
  if (changed.empty()) return 0;
  const Window measured = around(changed, reach_);
  if (!covers(before, changed) || !covers(test, around(changed, 2 * reach_)) ||
      !covers(map, measured)) {
    throw std::invalid_argument("The images do not cover what the change reaches.");
  }
  static thread_local std::vector<Window> tiles;
  tiles.clear();
  append_tiles_near_differences(before, test, changed, measured, reach_, tiles);
  double old_sum = 0, new_sum = 0;
  for (const Window& tile : tiles) old_sum += sum(map, tile);
  for (const Window& tile : tiles) {
    score_near_differences(test, tile, map);
    new_sum += sum(map, tile);
    // No distance is negative, so what follows takes nothing back.
    if (new_sum - old_sum > limit) break;
  }
  return new_sum - old_sum;
}

}  // namespace gradmesh
