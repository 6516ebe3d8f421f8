#pragma once

#include <vector>

#include "base/progress.h"
#include "error/merge_trial.h"
#include "select/analysis.h"

namespace gradmesh {

struct RegionPrice {
  Region region;
  double error;
};

/// The tensor product regions (paper 6.3) with a price of at most `limit`, by rising size and name.
/// They grow from single edges, by one row or column at a time, wherever the smaller one keeps to
/// the limit; each is priced once, from whichever side it is reached. On large smooth meshes, where
/// that would be hundreds for each patch, only the best go on growing after some time. Fewer where
/// `watch` says to stop.
std::vector<RegionPrice> price_regions(MergeTrial& trial, Analysis& analysis, double limit,
                                       StopWatch& watch);

/// Those of the regions that hold the patch, in their order.
std::vector<RegionPrice> regions_with(const Mesh& mesh, const std::vector<RegionPrice>& regions,
                                      Face patch);

}  // namespace gradmesh
