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

/// In eight running sums that do not wait for each other, whatever the processor.
double sum(const float* row, int count) {
  constexpr int lanes = 8;
  std::array<double, lanes> totals{};
  int i = 0;
  for (; i + lanes <= count; i += lanes)
    for (int lane = 0; lane < lanes; ++lane) totals[lane] += row[i + lane];
  for (; i < count; ++i) totals[i % lanes] += row[i];
  return std::accumulate(totals.begin(), totals.end(), 0.0);
}

}  // namespace

std::unique_ptr<Metric> make_metric(MetricKind kind, Image reference) {
  switch (kind) {
    case MetricKind::flip:
      return std::make_unique<Flip>(std::move(reference));
    case MetricKind::ssim:
      return std::make_unique<Ssim>(std::move(reference));
  }
  throw std::invalid_argument("Unknown metric.");
}

int metric_reach(MetricKind kind) {
  return kind == MetricKind::flip ? appearance_reach : ssim_radius;
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
