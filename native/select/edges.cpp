#include "select/edges.h"

#include <limits>

namespace gradmesh {

std::vector<Halfedge> inner_edges(const Mesh& mesh) {
  std::vector<Halfedge> edges;
  for (const Halfedge h : mesh.halfedges())
    if (!mesh.is_bar(h) && mesh[h].twin.valid() && mesh.curve(h) == h) edges.push_back(h);
  return edges;
}

std::vector<EdgePrice> price_edges(MergeTrial& trial, Analysis& analysis, StopWatch& watch) {
  const Mesh& mesh = trial.mesh();
  const std::vector<Halfedge> edges = inner_edges(mesh);
  std::vector<EdgePrice> prices;
  for (const Halfedge edge : edges) {
    if (watch.should_stop({prices.size(), edges.size(), mesh.face_count(), trial.error()})) break;
    const MergeObstacle obstacle = can_merge(mesh, edge);
    const double error = obstacle == MergeObstacle::none
                             ? price(trial, analysis, region_of_edge(mesh, edge))
                             : std::numeric_limits<double>::infinity();
    prices.push_back({edge, obstacle, error});
  }
  return prices;
}

void try_edges(MergeTrial& trial, std::vector<Halfedge> edges, StopWatch& watch) {
  const std::size_t total = edges.size();
  std::size_t tried = 0;
  for (int merges = 1; merges > 0;) {
    merges = 0;
    std::vector<Halfedge> waiting;
    for (const Halfedge edge : edges) {
      const Mesh& mesh = trial.mesh();
      if (watch.should_stop({tried, total, mesh.face_count(), trial.error()})) return;
      if (mesh[edge].alive && can_merge(mesh, edge) != MergeObstacle::none) {
        waiting.push_back(edge);
        continue;
      }
      ++tried;
      merges += trial.try_merge(edge);
    }
    edges = std::move(waiting);
  }
}

}  // namespace gradmesh
