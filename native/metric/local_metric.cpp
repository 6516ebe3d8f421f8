#include "metric/local_metric.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "base/parallel.h"
#include "base/per_thread.h"
#include "metric/differences.h"

namespace gradmesh {
namespace {

/// The most rows in a strip of which all filtered planes stay in the cache.
constexpr int strip_height = 64;
/// The most rows in a tile of an update. They are fewer because an update may give up between two
/// tiles, and because smaller tiles enclose changes more closely.
constexpr int step_height = 32;

template <class Raster>
bool covers(const Raster& raster, Window window) {
  return window.clipped(raster.window()) == window;
}

int area(const Window& window) { return window.width() * window.height(); }

}  // namespace

void for_each_strip(Window window, const std::function<void(Window)>& body) {
  const int height = window.height(), count = (height + strip_height - 1) / strip_height;
  parallel_for(count, [&](std::size_t i) {
    body({window.x0, window.y0 + height * int(i) / count, window.x1,
          window.y0 + height * int(i + 1) / count});
  });
}

void LocalMetric::score_near_differences(const Image& test, Window window, Plane& map) const {
  // Kept from call to call, as there may be hundreds of thousands of calls.
  auto& tiles = per_thread<std::vector<Window>, struct TilesOfCall>();
  tiles.clear();
  append_tiles_near_differences(reference_, test, around(window, reach_), window, reach_,
                                strip_height, tiles);
  const bool all = tiles.size() == 1 && tiles.front() == window;
  if (!all) fill(map, window, 0.0F);
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
  auto& tiles = per_thread<std::vector<Window>, struct TilesOfUpdate>();
  tiles.clear();
  append_tiles_near_differences(before, test, changed, measured, reach_, step_height, tiles);
  double old_sum = 0;
  for (const Window& tile : tiles) old_sum += sum(map, tile);
  // The largest tiles are scored first, as they soonest show that the sum rises too much; the sums
  // are added from top to bottom all the same. No distance is negative, so a sum that is still 0
  // takes nothing back.
  auto& sums = per_thread<std::vector<double>, struct Sums>();
  sums.assign(tiles.size(), 0);
  auto& order = per_thread<std::vector<std::size_t>, struct Order>();
  order.resize(tiles.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::ranges::sort(order, [&](std::size_t i, std::size_t j) {
    const int area_i = area(tiles[i]), area_j = area(tiles[j]);
    return area_i != area_j ? area_i > area_j : i < j;
  });
  double rise = 0;
  for (const std::size_t i : order) {
    score_near_differences(test, tiles[i], map);
    sums[i] = sum(map, tiles[i]);
    rise = std::accumulate(sums.begin(), sums.end(), 0.0) - old_sum;
    if (rise > limit) break;
  }
  return rise;
}

}  // namespace gradmesh
