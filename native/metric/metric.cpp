#include "metric/metric.h"

#include <stdexcept>
#include <utility>

#include "metric/flip.h"
#include "metric/ssim.h"

namespace gradmesh {

std::unique_ptr<Metric> make_metric(MetricKind kind, Image reference) {
  switch (kind) {
    case MetricKind::flip:
      return std::make_unique<Flip>(std::move(reference));
    case MetricKind::ssim:
      return std::make_unique<Ssim>(std::move(reference));
  }
  throw std::invalid_argument("Unknown metric.");
}

double mean(const Plane& map) {
  if (map.samples.empty()) return 0;
  double total = 0;
  for (int y = 0; y < map.height; ++y) {
    double row = 0;
    for (int x = 0; x < map.width; ++x) row += *map.at(x, y);
    total += row;
  }
  return total / double(map.samples.size());
}

}  // namespace gradmesh
