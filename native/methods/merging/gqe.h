#pragma once

#include <vector>

#include "methods/merging/regions.h"

namespace gradmesh {

/// Greedy quad-error (paper 6.3): merges regions that do not overlap, the best by Eq. 7 first, as
/// long as their prices together stay below gamma; gamma is searched for in N = 10 halvings of [0,
/// 2 epsilon], since prices only nearly add up. Where the mesh has an error from before, the room
/// that is left takes the place of epsilon. Beyond the paper, some more values of gamma are tried,
/// and each outcome is mended by the true error: where the set costs more than epsilon, the regions
/// that cost too much beside the others are left out, and whatever still fits is merged as well.
/// The best outcome is merged.
struct GqeOptions {
  /// Weight of a region's size against its error, 0..1.
  double omega = 0.75;
  /// True if a region is ranked together with its best partner as well (Eq. 8, 1-step GQE). Ranking
  /// by Eq. 7 is tried beside it, so that the outcome has never more patches.
  bool look_ahead = false;
};

/// Merges the best set of these regions that keeps to epsilon. `regions` are those of price_regions
/// with the trial's room as the limit.
void select_gqe(MergeTrial& trial, const std::vector<RegionPrice>& regions,
                const GqeOptions& options, StopWatch& watch);

/// Runs the whole method, in rounds: the first is that of the paper; each later one prices regions
/// on the mesh as it then is, until no region fits any more. `analysis` is of the mesh as it is
/// now.
void merge_by_gqe(MergeTrial& trial, PriceTable& analysis, const GqeOptions& options,
                  StopWatch& watch);

}  // namespace gradmesh
