#pragma once

#include <vector>

#include "base/progress.h"
#include "pricing/price_table.h"
#include "trial/merge_trial.h"

namespace gradmesh {

/// What merging a region would cost.
struct RegionPrice {
  Region region;
  std::vector<Face> patches;
  /// By how much that alone raises the error.
  double error;

  int size() const { return int(patches.size()); }
};

/// The tensor product regions (paper 6.3) with a price of at most `limit`, by rising size and name.
/// They grow from single curves, by one step at a time, wherever the smaller one keeps to the
/// limit; each is priced once, from whichever side it is reached. On large smooth meshes, where
/// that would be hundreds for each patch, only the best go on growing after some time. Fewer where
/// `watch` says to stop.
std::vector<RegionPrice> price_regions(MergeTrial& trial, PriceTable& analysis, double limit,
                                       StopWatch& watch);

/// Those of the regions that hold the patch, in their order.
std::vector<RegionPrice> regions_with(const std::vector<RegionPrice>& regions, Face patch);

}  // namespace gradmesh
