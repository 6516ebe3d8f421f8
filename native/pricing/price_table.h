#pragma once

#include <cstdint>
#include <limits>
#include <map>

#include "mesh/mesh.h"
#include "mesh/region.h"
#include "metric/metric.h"
#include "raster/frame.h"
#include "reference/original.h"
#include "trial/merge_trial.h"

namespace gradmesh {

/// What the prices of an analysis depend on.
struct PriceTableKey {
  /// Hash of the original, whose picture counts.
  std::uint64_t original = 0;
  /// Hash of the mesh that is merged, of where it lies in the frame, of what is hidden
  /// there and of the weights of its pixels.
  std::uint64_t content = 0;
  MetricKind metric = MetricKind::flip;
  /// Size of the frame in pixels.
  int width = 0, height = 0;
  ColorModel color_model = ColorModel::bilinear;

  bool operator==(const PriceTableKey&) const = default;
};

PriceTableKey analysis_key(const Original& original, const Mesh& mesh, const Frame& frame,
                           MetricKind metric);

/// By how much merging a region alone raises the error; infinity if it cannot be merged.
struct Price {
  double error = 0;
  /// False if it is only known that the price is above `error`, as it was not worked out further.
  bool exact = true;

  /// Returns true if the price decides whether merging the region keeps to the limit: it is exact,
  /// or known to be above the limit.
  bool decides(double limit) const { return exact || error > limit; }
  bool operator==(const Price&) const = default;
};

/// Returns the price of the region; exact up to `limit`.
Price find_price(RegionTrial& trial, const Region& region,
                 double limit = std::numeric_limits<double>::infinity());

/// The prices of single regions of a mesh: the preprocessing of the paper's 6.2 and 6.3 (B.3). An
/// edge is the region of its two patches. The prices depend on neither epsilon nor omega nor kappa,
/// and a caller that needs a price that is not there yet adds it.
struct PriceTable {
  PriceTableKey key;
  /// Prices by the names of the regions, as of region_name.
  std::map<Region, Price> prices;

  /// Returns the price of a region if it is known and decides whether the region keeps to the
  /// limit, else null.
  const Price* known(const Region& name, double limit) const {
    const auto found = prices.find(name);
    return found != prices.end() && found->second.decides(limit) ? &found->second : nullptr;
  }
};

}  // namespace gradmesh
