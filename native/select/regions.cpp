#include "select/regions.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "select/edges.h"

namespace gradmesh {
namespace {

/// The names of the regions with one row or column more than this one.
void add_larger(const Mesh& mesh, const Region& region, std::set<Region>& names) {
  const std::vector<Halfedge> tops = region_tops(mesh, region);
  for (Region view : region_views(mesh, region, tops)) {
    ++view.columns;
    if (const auto larger = region_tops(mesh, view); !larger.empty())
      names.insert(region_name(mesh, view, larger));
  }
}

}  // namespace

std::vector<RegionPrice> price_regions(MergeTrial& trial, Analysis& analysis, double limit,
                                       StopWatch& watch) {
  const Mesh& mesh = trial.mesh();
  // Larger regions wait with those of their size, so that each comes after all that lead to it.
  std::vector<std::set<Region>> of_size(mesh.face_count() + 1);
  std::size_t known = 0, done = 0;
  for (const Halfedge edge : inner_edges(mesh))
    if (mesh.is_leaf(edge) && leaf_across(mesh, edge).valid())
      known += of_size[2].insert(region_of_edge(mesh, edge)).second;

  std::vector<RegionPrice> regions;
  for (int size = 2; size <= mesh.face_count(); ++size)
    for (const Region& region : of_size[size]) {
      if (watch.should_stop({done++, known, mesh.face_count(), trial.error()})) return regions;
      const double error = price(trial, analysis, region);
      if (error > limit) continue;
      regions.push_back({region, error});
      std::set<Region> larger;
      add_larger(mesh, region, larger);
      for (const Region& next : larger) known += of_size[next.size()].insert(next).second;
    }
  return regions;
}

std::vector<RegionPrice> regions_with(const Mesh& mesh, const std::vector<RegionPrice>& regions,
                                      Face patch) {
  std::vector<RegionPrice> found;
  std::ranges::copy_if(regions, std::back_inserter(found), [&](const RegionPrice& r) {
    return std::ranges::any_of(region_tops(mesh, r.region),
                               [&](Halfedge top) { return mesh.face(top) == patch; });
  });
  return found;
}

}  // namespace gradmesh
