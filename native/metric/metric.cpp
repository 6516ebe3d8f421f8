#include "metric/metric.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>

#include "base/parallel.h"
#include "base/per_thread.h"
#include "metric/differences.h"
#include "metric/flip.h"
#include "metric/ssim.h"

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

/// Sums `count` samples in eight running sums that do not wait for each other, whatever the
/// processor.
double sum(const float* row, int count) {
  constexpr int lanes = 8;
  std::array<double, lanes> totals{};
  int i = 0;
  for (; i + lanes <= count; i += lanes)
    for (int lane = 0; lane < lanes; ++lane) totals[lane] += row[i + lane];
  for (; i < count; ++i) totals[i % lanes] += row[i];
  return std::accumulate(totals.begin(), totals.end(), 0.0);
}

template <class Made>
std::unique_ptr<Metric> make(Image reference, Metric::Weights weights) {
  return std::make_unique<Made>(std::move(reference), std::move(weights));
}

void multiply(const Plane& weights, Window window, Plane& map) {
  for (int y = window.y0; y < window.y1; ++y)
    std::transform(map.at(window.x0, y), map.at(window.x0, y) + window.width(),
                   weights.at(window.x0, y), map.at(window.x0, y), std::multiplies<>());
}

}  // namespace

Metric::Metric(Image reference, int reach, Weights weights)
    : reference_(std::move(reference)), reach_(reach), weights_(std::move(weights)) {
  if (weights_ && weights_->window() != reference_.window())
    throw std::invalid_argument("The weights of a metric must have the size of its reference.");
}

void Metric::for_each_strip(Window window, const std::function<void(Window)>& body) {
  const int height = window.height(), count = (height + strip_height - 1) / strip_height;
  parallel_for(count, [&](std::size_t i) {
    body({window.x0, window.y0 + height * int(i) / count, window.x1,
          window.y0 + height * int(i + 1) / count});
  });
}

void Metric::score_near_differences(const Image& test, Window window, Plane& map) const {
  // Kept from call to call, as there may be hundreds of thousands of calls.
  auto& tiles = per_thread<std::vector<Window>, struct TilesOfCall>();
  tiles.clear();
  append_tiles_near_differences(reference_, test, around(window, reach_), window, reach_,
                                strip_height, tiles);
  const bool all = tiles.size() == 1 && tiles.front() == window;
  if (!all) fill(map, window, 0.0F);
  for (const Window& tile : tiles) {
    score(test, tile, map);
    if (weights_) multiply(*weights_, tile, map);
  }
}

void Metric::fill_map(const Image& test, Window window, Plane& map) const {
  if (test.window() != reference_.window() || map.window() != reference_.window()) {
    throw std::invalid_argument("The images that a metric compares must have the same size.");
  }
  const Window inside = window.clipped(reference_.window());
  for_each_strip(inside, [&](Window strip) { score_near_differences(test, strip, map); });
}

double Metric::update_map_in_parallel(const Image& before, const Image& test, Window changed,
                                      Plane& map, double limit) const {
  return updated(before, test, changed, map, limit, thread_count());
}

double Metric::updated(const Image& before, const Image& test, Window changed, Plane& map,
                       double limit, std::size_t at_once) const {
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
  std::ranges::sort(order, {}, [&](std::size_t i) { return std::pair(-area(tiles[i]), i); });
  const auto score_tile = [&](std::size_t i) {
    score_near_differences(test, tiles[i], map);
    return sum(map, tiles[i]);
  };
  auto& found = per_thread<std::vector<double>, struct Found>();
  double rise = 0;
  for (std::size_t first = 0; first < order.size(); first += at_once) {
    found.resize(std::min(at_once, order.size() - first));
    if (found.size() == 1)
      found[0] = score_tile(order[first]);
    else
      parallel_for(found.size(), [&](std::size_t n) { found[n] = score_tile(order[first + n]); });
    // One tile after the other, so that it gives up after the same one on any number of threads.
    for (std::size_t n = 0; n < found.size(); ++n) {
      sums[order[first + n]] = found[n];
      rise = std::accumulate(sums.begin(), sums.end(), 0.0) - old_sum;
      if (rise > limit) return rise;
    }
  }
  return rise;
}

const std::vector<MetricEntry>& all_metrics() {
  static const std::vector<MetricEntry> entries = {
      {MetricKind::flip, "flip", "FLIP", appearance_reach, make<Flip>},
      {MetricKind::ssim, "ssim", "1 - SSIM", ssim_radius, make<Ssim>},
  };
  return entries;
}

const MetricEntry& metric_entry(MetricKind kind) {
  for (const MetricEntry& entry : all_metrics())
    if (entry.kind == kind) return entry;
  throw std::invalid_argument("Unknown metric.");
}

MetricKind metric_named(const std::string& wanted) {
  std::string known;
  for (const MetricEntry& entry : all_metrics()) {
    if (wanted == entry.name) return entry.kind;
    known.append(known.empty() ? "" : ", ").append(entry.name);
  }
  throw std::invalid_argument("the metric '" + wanted + "' is not known; there are: " + known +
                              ".");
}

std::unique_ptr<Metric> make_metric(MetricKind kind, Image reference, Metric::Weights weights) {
  return metric_entry(kind).make(std::move(reference), std::move(weights));
}

double sum(const Plane& map, Window window) {
  double total = 0;
  for (int y = window.y0; y < window.y1; ++y) total += sum(map.at(window.x0, y), window.width());
  return total;
}

double mean(const Plane& map) {
  return map.samples.empty() ? 0 : sum(map, map.window()) / double(map.samples.size());
}

}  // namespace gradmesh
