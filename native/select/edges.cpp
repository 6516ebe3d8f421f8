#include "select/edges.h"

#include <limits>
#include <optional>

#include "error/parallel_trials.h"

namespace gradmesh {

std::vector<Halfedge> inner_edges(const Mesh& mesh) {
  std::vector<Halfedge> edges;
  for (const Halfedge h : mesh.halfedges())
    if (!mesh.is_bar(h) && mesh[h].twin.valid() && mesh.curve(h) == h) edges.push_back(h);
  return edges;
}

std::vector<EdgePrice> price_edges(MergeTrial& trial, Analysis& analysis, StopWatch& watch) {
  const Mesh& mesh = trial.mesh();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::vector<Halfedge> edges = inner_edges(mesh);
  std::vector<MergeObstacle> obstacles;
  std::vector<Region> unknown;
  for (const Halfedge edge : edges) {
    obstacles.push_back(can_merge(mesh, edge));
    if (obstacles.back() != MergeObstacle::none) continue;
    const Region name = region_of_edge(mesh, edge);
    if (!analysis.known(name, infinity)) unknown.push_back(name);
  }

  std::vector<std::optional<Price>> found(unknown.size());
  // As it is now: while edges are tried, another thread may have merged one in `mesh`.
  Progress progress{0, unknown.size(), mesh.face_count(), trial.error()};
  const auto stop = [&](std::size_t done) {
    progress.done = done;
    return watch.should_stop(progress);
  };
  ParallelTrials(trial).for_each(unknown.size(), stop, [&](MergeTrial& own, std::size_t i) {
    RegionTrial region_trial(own, own.mesh());
    found[i] = find_price(region_trial, unknown[i]);
  });
  for (std::size_t i = 0; i < unknown.size(); ++i)
    if (found[i]) analysis.prices[unknown[i]] = *found[i];

  std::vector<EdgePrice> prices;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (obstacles[i] != MergeObstacle::none)
      prices.push_back({edges[i], obstacles[i], infinity});
    else if (const Price* known = analysis.known(region_of_edge(mesh, edges[i]), infinity))
      prices.push_back({edges[i], obstacles[i], known->error});
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
