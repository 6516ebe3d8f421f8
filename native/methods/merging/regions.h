#pragma once

#include <vector>

#include "base/progress.h"
#include "pricing/price_table.h"
#include "trial/merge_trial.h"

namespace gradmesh {

/// A region with its patches and its price.
struct RegionPrice {
  Region region;
  std::vector<Face> patches;
  /// By how much merging the region alone raises the error.
  double error;

  int size() const { return int(patches.size()); }
};

/// Returns the tensor product regions (paper 6.3) with a price of at most `limit`, by rising size
/// and name. Regions grow from single curves, by one step at a time, wherever the smaller region
/// keeps to the limit; each is priced once, from whichever side it is reached. On large smooth
/// meshes, which have hundreds of regions for each patch, only the best go on growing after some
/// number of regions. Returns fewer regions if `watch` says to stop.
std::vector<RegionPrice> price_regions(MergeTrial& trial, PriceTable& analysis, double limit,
                                       StopWatch& watch);

/// Returns those of the regions that hold the patch, in their order.
std::vector<RegionPrice> regions_with(const std::vector<RegionPrice>& regions, Face patch);

}  // namespace gradmesh
