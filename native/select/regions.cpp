#include "select/regions.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "error/parallel_trials.h"
#include "select/edges.h"

namespace gradmesh {
namespace {

/// The names of the regions with one row or column more than this one.
void add_larger(const Mesh& mesh, const Region& region, std::vector<Region>& names) {
  const std::vector<Halfedge> tops = region_tops(mesh, region);
  for (Region view : region_views(mesh, region, tops)) {
    ++view.columns;
    if (const auto larger = region_tops(mesh, view); !larger.empty())
      names.push_back(region_name(mesh, view, larger));
  }
}

void sort_each_once(std::vector<Region>& names) {
  std::ranges::sort(names);
  names.erase(std::unique(names.begin(), names.end()), names.end());
}

class Growth {
 public:
  Growth(MergeTrial& trial, Analysis& analysis, double limit, StopWatch& watch)
      : trial_(trial), analysis_(analysis), limit_(limit), watch_(watch), trials_(trial) {}

  std::vector<RegionPrice> run() {
    const Mesh& mesh = trial_.mesh();
    std::vector<Region> wave;
    for (const Halfedge edge : inner_edges(mesh))
      if (mesh.is_leaf(edge) && leaf_across(mesh, edge).valid())
        wave.push_back(region_of_edge(mesh, edge));
    sort_each_once(wave);
    // Regions of one wave have as many rows and columns together, those that lead to them one less.
    while (!wave.empty()) wave = price(wave) ? larger_than(keep(wave)) : (keep(wave), Wave());
    std::ranges::stable_sort(
        regions_, {}, [](const RegionPrice& r) { return std::pair(r.region.size(), r.region); });
    return std::move(regions_);
  }

 private:
  using Wave = std::vector<Region>;

  /// Finds the prices that are not known yet; whether there was time for all of them.
  bool price(const Wave& wave) {
    Wave unknown;
    std::ranges::copy_if(wave, std::back_inserter(unknown),
                         [&](const Region& r) { return !analysis_.known(r, limit_); });
    std::vector<std::optional<Price>> found(unknown.size());
    const auto stop = [&](std::size_t done) {
      return watch_.should_stop(
          {done_ + done, done_ + unknown.size(), trial_.mesh().face_count(), trial_.error()});
    };
    const bool all = trials_.for_each(unknown.size(), stop, [&](MergeTrial& own, std::size_t i) {
      found[i] = find_price(own, unknown[i], limit_);
    });
    for (std::size_t i = 0; i < unknown.size(); ++i)
      if (found[i]) analysis_.prices[unknown[i]] = *found[i];
    done_ += unknown.size();
    return all;
  }

  /// Takes those of the wave that keep to the limit; returns them.
  Wave keep(const Wave& wave) {
    Wave kept;
    for (const Region& region : wave)
      if (const Price* price = analysis_.known(region, limit_); price && price->error <= limit_) {
        regions_.push_back({region, price->error});
        kept.push_back(region);
      }
    return kept;
  }

  Wave larger_than(const Wave& kept) const {
    Wave larger;
    for (const Region& region : kept) add_larger(trial_.mesh(), region, larger);
    sort_each_once(larger);
    return larger;
  }

  MergeTrial& trial_;
  Analysis& analysis_;
  const double limit_;
  StopWatch& watch_;
  ParallelTrials trials_;
  std::size_t done_ = 0;
  std::vector<RegionPrice> regions_;
};

}  // namespace

std::vector<RegionPrice> price_regions(MergeTrial& trial, Analysis& analysis, double limit,
                                       StopWatch& watch) {
  return Growth(trial, analysis, limit, watch).run();
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
