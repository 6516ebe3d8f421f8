#include "methods/merging/edges.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>

#include "pricing/batch_prices.h"
#include "pricing/parallel_trials.h"

namespace gradmesh {

namespace {

/// Returns the prices of the regions, found many at once on the trial's device. Some are missing if
/// the device fails.
std::vector<std::optional<double>> prices_on_device(
    MergeTrial& trial, ParallelTrials<MergeTrial>& trials, const std::vector<Region>& regions,
    const std::function<bool(std::size_t done)>& stop) {
  std::vector<PricedChain> chains;
  for (const Region& region : regions) chains.emplace_back(std::vector{region});
  try {
    const Mesh start = trial.mesh();
    BatchPrices(trial, trials, start).price(chains, std::numeric_limits<double>::infinity(), stop);
  } catch (const DeviceError& error) {
    trial.lose_device(error);
  }
  std::vector<std::optional<double>> errors;
  for (const PricedChain& chain : chains) errors.push_back(chain.errors.front());
  return errors;
}

void find_prices(MergeTrial& trial, const std::vector<Region>& regions, PriceTable& analysis,
                 StopWatch& watch) {
  // As it is now: while edges are tried, another thread may have merged one in the mesh.
  Progress progress{0, regions.size(), trial.mesh().face_count(), trial.error()};
  const auto stop = [&](std::size_t done) {
    progress.done = done;
    return watch.should_stop(progress);
  };
  ParallelTrials trials(trial);
  std::vector<std::optional<double>> found(regions.size());
  if (trial.has_device()) found = prices_on_device(trial, trials, regions, stop);
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < regions.size(); ++i)
    if (!found[i]) left.push_back(i);
  trials.for_each(left.size(), stop, [&](MergeTrial& own, std::size_t i) {
    RegionTrial region_trial(own, own.mesh());
    found[left[i]] = region_trial.price(regions[left[i]]);
  });
  for (std::size_t i = 0; i < regions.size(); ++i)
    if (found[i]) analysis.prices[regions[i]] = {*found[i], true};
}

}  // namespace

std::vector<Halfedge> inner_edges(const Mesh& mesh) {
  std::vector<Halfedge> edges = mesh.curves();
  std::erase_if(edges, [&](Halfedge h) { return !mesh[h].twin.valid(); });
  return edges;
}

std::vector<EdgePrice> price_edges(MergeTrial& trial, PriceTable& analysis, StopWatch& watch) {
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

  find_prices(trial, unknown, analysis, watch);

  std::vector<EdgePrice> prices;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (obstacles[i] != MergeObstacle::none)
      prices.push_back({edges[i], obstacles[i], infinity});
    else if (const Price* known = analysis.known(region_of_edge(mesh, edges[i]), infinity))
      prices.push_back({edges[i], obstacles[i], known->error});
  }
  return prices;
}

void try_edges(MergeTrial& trial, const EdgeOrder& order, StopWatch& watch) {
  const Mesh& mesh = trial.mesh();
  // Nearly all is done in the first round, so that is what those who watch are told.
  std::size_t tried = 0, total = 0;
  for (bool merged = true; merged;) {
    merged = false;
    const std::vector<Halfedge> edges = order(mesh);
    if (total == 0) total = edges.size();
    for (const Halfedge edge : edges) {
      if (watch.should_stop({std::min(tried, total), total, mesh.face_count(), trial.error()}))
        return;
      ++tried;
      merged = trial.try_edge(edge) || merged;
    }
  }
}

}  // namespace gradmesh
