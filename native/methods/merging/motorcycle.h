#pragma once

#include <cstdint>
#include <vector>

#include "methods/merging/edges.h"

namespace gradmesh {

/// The mesh cut into rectangles of patches whose inner edges are cheap to merge (paper 6.2, Fig.
/// 8).
struct MotorcycleGraph {
  /// Inner edges with a price above the limit.
  std::vector<Halfedge> costly;
  /// Inner edges that cannot be merged.
  std::vector<Halfedge> unmergeable;
  /// Edges marked on the paths that start where marked edges end or bend.
  std::vector<Halfedge> traced;
  /// The inner edges that are not marked, one list for each part of the mesh that has some, by
  /// rising sum of their prices.
  std::vector<std::vector<Halfedge>> parts;
};

/// Returns the motorcycle graph of a mesh. `prices` are those of price_edges; `limit` is kappa *
/// epsilon.
MotorcycleGraph motorcycle_graph(const Mesh& mesh, const std::vector<EdgePrice>& prices,
                                 double limit);

/// Returns all edges inside the parts, part by part, in the grid order (the paper's choice) of
/// `seed`.
std::vector<Halfedge> motorcycle_order(const Mesh& mesh, const MotorcycleGraph& graph,
                                       std::uint64_t seed);

struct MotorcycleOptions {
  /// Share of epsilon, 0 or more, above which edges bound the parts.
  double kappa = 0.05;
  std::uint64_t seed = 0;
};

/// Tries the edges in the motorcycle order, in rounds (try_edges), each with the prices and the
/// graph of the mesh as it then is. `analysis` is of the mesh as it is now.
void select_motorcycle(MergeTrial& trial, PriceTable& analysis, const MotorcycleOptions& options,
                       StopWatch& watch);

}  // namespace gradmesh
