#include "metric/metric.h"

#include <array>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "metric/flip.h"
#include "metric/ssim.h"
#include "metric/ssim_taps.h"

namespace gradmesh {
namespace {

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
std::unique_ptr<Metric> make(Image reference) {
  return std::make_unique<Made>(std::move(reference));
}

}  // namespace

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

std::unique_ptr<Metric> make_metric(MetricKind kind, Image reference) {
  return metric_entry(kind).make(std::move(reference));
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
