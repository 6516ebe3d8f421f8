#pragma once

#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "error/merge_trial.h"
#include "ops/merge.h"
#include "select/analysis.h"

namespace gradmesh {

/// Every edge between two patches once, as its curve's name; edges that T-junctions divide among
/// them.
std::vector<Halfedge> inner_edges(const Mesh& mesh);

/// What merging one edge would cost.
struct EdgePrice {
  Halfedge edge;
  /// Why it cannot be merged, or `none`.
  MergeObstacle obstacle;
  /// By how much merging it alone raises the error; infinity where it cannot be merged.
  double error;
};

/// The prices of all inner edges (paper 6.2). Fewer where `watch` says to stop.
std::vector<EdgePrice> price_edges(MergeTrial& trial, Analysis& analysis, StopWatch& watch);

/// Tries to merge the edges in this order. An edge that cannot be merged when its turn comes waits
/// for the next round, as long as merges still change what can be: so that what is left over cannot
/// be merged or costs too much (paper 6.1).
void try_edges(MergeTrial& trial, std::vector<Halfedge> edges, StopWatch& watch);

}  // namespace gradmesh
