#pragma once

#include <functional>
#include <vector>

#include "base/progress.h"
#include "ops/merge/merge.h"
#include "pricing/price_table.h"
#include "trial/merge_trial.h"

namespace gradmesh {

/// Returns every edge between two patches once, as its curve's name. Edges that T-junctions divide
/// are among them.
std::vector<Halfedge> inner_edges(const Mesh& mesh);

/// The price of an edge.
struct EdgePrice {
  Halfedge edge;
  /// Why the edge cannot be merged, or `none`.
  MergeObstacle obstacle;
  /// By how much merging the edge alone raises the error; infinity if it cannot be merged.
  double error;
};

/// Returns the prices of all inner edges (paper 6.2), or of fewer if `watch` says to stop.
std::vector<EdgePrice> price_edges(MergeTrial& trial, PriceTable& analysis, StopWatch& watch);

/// Returns the edges of a mesh that a method tries, in its order.
using EdgeOrder = std::function<std::vector<Halfedge>(const Mesh& mesh)>;

/// Tries to merge the edges in their order (paper 6.1), round after round, each in the order for
/// the mesh as it then is: merges join curves and change what can be merged. Ends after a round in
/// which nothing was merged, so that no edge of the order is left that could be merged.
void try_edges(MergeTrial& trial, const EdgeOrder& order, StopWatch& watch);

}  // namespace gradmesh
