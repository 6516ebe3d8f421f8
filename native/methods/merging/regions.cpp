#include "methods/merging/regions.h"

#include <algorithm>
#include <deque>
#include <iterator>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "methods/merging/edges.h"
#include "ops/merge/region_finder.h"
#include "pricing/batch_prices.h"
#include "pricing/parallel_trials.h"

namespace gradmesh {
namespace {

/// Regions with the same number of columns that start at the same patch and grow by rows, as they
/// are merged (merging_view): one more row costs the merges of that row only.
struct Chain {
  /// Views of the wanted regions, by rising number of rows.
  std::vector<Region> wanted;
  /// Names of the regions that were tried, and their prices.
  std::vector<std::pair<Region, Price>> found;
};

/// Number of regions tried for each patch of the mesh up to which all grow. Beyond it only those
/// grow that are the best for one of their patches in their wave: a large smooth mesh has hundreds
/// of rectangles at every patch, nearly all of them parts of others that are as good.
constexpr std::size_t tried_freely = 12;

class Growth {
 public:
  Growth(MergeTrial& trial, PriceTable& analysis, double limit, StopWatch& watch)
      : trial_(trial),
        mesh_(trial.mesh()),
        analysis_(analysis),
        limit_(limit),
        watch_(watch),
        error_(trial.error()),
        has_junctions_(
            std::ranges::any_of(mesh_.points(), [&](Point p) { return mesh_[p].is_junction(); })),
        trials_(trial) {}

  std::vector<RegionPrice> run() {
    finders_.emplace_back(mesh_);
    for (const Halfedge edge : inner_edges(mesh_))
      if (mesh_.is_leaf(edge) && leaf_across(mesh_, edge).valid())
        reach(region_of_edge(mesh_, edge));
      else if (const auto found = finders_.front().around(edge))
        reach(*found);
    for (bool in_time = true; in_time && !reached_.empty();) {
      const std::vector<Region> wave = std::exchange(reached_, {});
      const std::size_t kept = regions_.size();
      in_time = try_chains(chains_of(wave));
      for (const Region& name : wave) keep(name);
      std::vector<RegionPrice> growing(regions_.begin() + kept, regions_.end());
      const bool freely = seen_.size() <= most_freely();
      if (!freely) keep_best_for_a_patch(growing);
      in_time = in_time && reach_larger(growing, freely);
    }
    std::ranges::sort(regions_, {},
                      [](const RegionPrice& r) { return std::pair(r.size(), r.region); });
    return std::move(regions_);
  }

 private:
  /// Tells how many of the chains that are tried now are done.
  bool should_stop(std::size_t done, std::size_t chains) {
    return watch_.should_stop({done_ + done, done_ + chains, mesh_.face_count(), error_});
  }

  void reach(const Region& name) {
    if (seen_.insert(name).second) reached_.push_back(name);
  }
  void reach(const FoundRegion& found) {
    reach(found.name);
    found_.emplace(found.name, found.faces);
  }

  /// Takes the region if it keeps to the limit.
  void keep(const Region& name) {
    const Price* price = analysis_.known(name, limit_);
    if (!price || price->error > limit_) return;
    regions_.push_back({name, patches_of(name), price->error});
    kept_.insert(name);
  }

  std::vector<Face> patches_of(const Region& name) const {
    if (const auto found = found_.find(name); found != found_.end()) return found->second;
    return faces_of(region_tops(mesh_, name));
  }

  std::vector<Face> faces_of(const std::vector<Halfedge>& tops) const {
    std::vector<Face> faces;
    for (const Halfedge top : tops) faces.push_back(mesh_.face(top));
    return faces;
  }

  std::size_t most_freely() const { return tried_freely * std::size_t(mesh_.face_count()); }

  /// Keeps the regions that, for one of their patches, save the most patches for their error among
  /// all that hold it.
  void keep_best_for_a_patch(std::vector<RegionPrice>& regions) const {
    std::ranges::sort(regions, {}, [](const RegionPrice& r) {
      return std::tuple(r.error / (r.size() - 1), -r.size(), r.region);
    });
    std::vector<bool> has_better(mesh_.face_slots(), false);
    std::erase_if(regions, [&](const RegionPrice& r) {
      bool is_best = false;
      for (const Face patch : r.patches) {
        is_best = is_best || !has_better[std::size_t(patch.value)];
        has_better[std::size_t(patch.value)] = true;
      }
      return !is_best;
    });
  }

  /// Reaches the regions that are one step larger than some. If all grow `freely`, all parts of
  /// regions without T-junctions inside have been tried, and of these regions only those are
  /// reached that can be expected to keep to the limit. Returns true if there was time for all of
  /// them.
  bool reach_larger(const std::vector<RegionPrice>& growing, bool freely) {
    std::vector<std::vector<MergedArea>> areas(growing.size());
    if (has_junctions_ && !find_larger(growing, areas)) return false;
    for (std::size_t i = 0; i < growing.size(); ++i) {
      if (should_stop(0, growing.size())) return false;
      for (const MergedArea& area : areas[i])
        if (const std::optional<Region>& name = names_.at(area.faces)) reach({*name, area.faces});
      reach_larger_grids(growing[i].region, freely);
    }
    return true;
  }

  /// Finds the areas with T-junctions inside that are one step larger than each region, and names
  /// them. Returns true if there was time for all of them.
  bool find_larger(const std::vector<RegionPrice>& regions,
                   std::vector<std::vector<MergedArea>>& areas) {
    while (finders_.size() < thread_count()) finders_.emplace_back(mesh_);
    const auto stop = [&](std::size_t) { return should_stop(0, regions.size()); };
    const auto in_turn = [&](std::size_t count, const auto& find) {
      return for_each_in_turn(finders_.size(), count, stop,
                              [&](std::size_t own, std::size_t i) { find(finders_[own], i); });
    };
    if (!in_turn(regions.size(), [&](RegionFinder& finder, std::size_t i) {
          areas[i] = larger_than(regions[i].region, finder);
        }))
      return false;
    // Neighbours have larger ones in common, and to find a name takes merging the area once more.
    std::vector<std::pair<const MergedArea*, std::optional<Region>*>> unnamed;
    for (const auto& of_region : areas)
      for (const MergedArea& area : of_region)
        if (const auto [at, is_new] = names_.try_emplace(area.faces); is_new)
          unnamed.emplace_back(&area, &at->second);
    return in_turn(unnamed.size(), [&](RegionFinder& finder, std::size_t i) {
      const std::optional<FoundRegion> found = finder.named(*unnamed[i].first);
      if (found && region_tops(mesh_, found->name).empty()) *unnamed[i].second = found->name;
    });
  }

  /// Returns the areas that are one step larger than a region and are no grids of patches.
  std::vector<MergedArea> larger_than(const Region& name, RegionFinder& finder) const {
    std::vector<std::vector<Face>> grids;
    if (const std::vector<Halfedge> tops = region_tops(mesh_, name); !tops.empty())
      for (Region view : region_views(mesh_, name, tops)) {
        ++view.columns;
        grids.push_back(faces_of(region_tops(mesh_, view)));
        std::ranges::sort(grids.back());
      }
    std::vector<MergedArea> larger;
    for (std::optional<MergedArea> area : finder.larger(name))
      if (area && std::ranges::find(grids, area->faces) == grids.end())
        larger.push_back(*std::move(area));
    return larger;
  }

  /// Reaches those without T-junctions inside.
  void reach_larger_grids(const Region& name, bool freely) {
    const std::vector<Halfedge> tops = region_tops(mesh_, name);
    if (tops.empty()) return;
    for (Region view : region_views(mesh_, name, tops)) {
      ++view.columns;
      const auto larger = region_tops(mesh_, view);
      if (larger.empty()) continue;
      if (!freely || keeps_all_parts(view, larger)) reach(region_name(mesh_, view, larger));
    }
  }

  /// Returns true if every part of a region that lacks one row or column keeps to the limit: where
  /// a part did not, the whole was never seen to do so either.
  bool keeps_all_parts(const Region& region, const std::vector<Halfedge>& tops) const {
    for (Region part : region_views(mesh_, region, tops)) {
      --part.columns;
      if (part.size() > 1 && !kept_.contains(region_name(mesh_, part, region_tops(mesh_, part))))
        return false;
    }
    return true;
  }

  std::vector<Chain> chains_of(const std::vector<Region>& wave) const {
    std::map<std::tuple<Face, int, int>, Chain> chains;
    for (const Region& name : wave)
      if (!analysis_.known(name, limit_)) {
        const Region view = merging_view(mesh_, name);
        chains[{view.face, view.top, view.columns}].wanted.push_back(view);
      }
    std::vector<Chain> list;
    for (auto& [start, chain] : chains) {
      std::ranges::sort(chain.wanted);
      list.push_back(std::move(chain));
    }
    return list;
  }

  /// Finds the prices of the chains. Returns true if there was time for all of them.
  bool try_chains(std::vector<Chain> chains) {
    if (trial_.has_device()) return try_on_device(std::move(chains));
    const auto stop = [&](std::size_t done) { return should_stop(done, chains.size()); };
    const bool all = trials_.for_each(
        chains.size(), stop, [&](MergeTrial& own, std::size_t i) { try_chain(own, chains[i]); });
    done_ += chains.size();
    for (const Chain& chain : chains)
      for (const auto& [name, price] : chain.found) analysis_.prices[name] = price;
    return all;
  }

  /// Finds the prices of the chains with many regions at once on the device. Where the device fails
  /// the rest is priced without it.
  bool try_on_device(std::vector<Chain> chains) {
    std::vector<PricedChain> priced;
    for (Chain& chain : chains) priced.emplace_back(chain.wanted);
    const auto stop = [&](std::size_t done) { return should_stop(done, chains.size()); };
    bool all = true;
    try {
      if (!batches_) batches_ = std::make_unique<BatchPrices>(trial_, trials_, mesh_);
      all = batches_->price(priced, limit_, stop);
    } catch (const DeviceError& error) {
      trial_.lose_device(error);
    }
    std::vector<Chain> left;
    for (std::size_t i = 0; i < chains.size(); ++i) {
      for (std::size_t k = 0; k < priced[i].regions.size(); ++k) {
        const Region& view = priced[i].regions[k];
        if (priced[i].errors[k]) analysis_.prices[name_of(view)] = {*priced[i].errors[k], true};
      }
      if (!priced[i].is_priced()) left.push_back(std::move(chains[i]));
    }
    done_ += chains.size() - left.size();
    return trial_.has_device() ? all : try_chains(std::move(left));
  }

  void try_chain(MergeTrial& own, Chain& chain) const {
    RegionTrial trial(own, mesh_);
    auto wanted = chain.wanted.begin();
    for (Region view = *wanted;;) {
      const Price price = find_price(trial, view, limit_);
      chain.found.emplace_back(name_of(view), price);
      if (wanted != chain.wanted.end() && *wanted == view) ++wanted;
      ++view.rows;
      if (price.error <= limit_ && goes_on_to(view)) continue;
      if (wanted == chain.wanted.end()) return;
      view = *wanted;
    }
  }

  /// Returns true if the region that comes next in a chain, after one that keeps to the limit, has
  /// no price yet and is merged in that view. Its turn would come in a later wave; pricing it now
  /// takes less time.
  bool goes_on_to(const Region& view) const {
    if (view.rows > view.columns || 2 * seen_.size() > most_freely()) return false;
    const std::vector<Halfedge> tops = region_tops(mesh_, view);
    if (tops.empty()) return false;
    const Region name = region_name(mesh_, view, tops);
    return !analysis_.known(name, limit_) && merging_view(mesh_, name) == view;
  }

  /// Returns the name of a region that is given in its merging_view.
  Region name_of(const Region& view) const {
    const std::vector<Halfedge> tops = region_tops(mesh_, view);
    return tops.empty() ? view : region_name(mesh_, view, tops);
  }

  MergeTrial& trial_;
  /// The mesh as it is before anything is tried.
  const Mesh mesh_;
  PriceTable& analysis_;
  const double limit_;
  StopWatch& watch_;
  const double error_;
  const bool has_junctions_;
  /// One for each thread; one where there are no T-junctions.
  std::deque<RegionFinder> finders_;
  /// The names of areas with T-junctions inside that were found, by their patches; none of those
  /// that are no regions.
  std::map<std::vector<Face>, std::optional<Region>> names_;
  /// The patches of the regions that the finder has found.
  std::map<Region, std::vector<Face>> found_;
  ParallelTrials<MergeTrial> trials_;
  std::unique_ptr<BatchPrices> batches_;
  std::set<Region> seen_, kept_;
  /// Regions that were seen, but not tried yet.
  std::vector<Region> reached_;
  std::size_t done_ = 0;
  std::vector<RegionPrice> regions_;
};

}  // namespace

std::vector<RegionPrice> price_regions(MergeTrial& trial, PriceTable& analysis, double limit,
                                       StopWatch& watch) {
  return Growth(trial, analysis, limit, watch).run();
}

std::vector<RegionPrice> regions_with(const std::vector<RegionPrice>& regions, Face patch) {
  std::vector<RegionPrice> found;
  std::ranges::copy_if(regions, std::back_inserter(found), [&](const RegionPrice& r) {
    return std::ranges::find(r.patches, patch) != r.patches.end();
  });
  return found;
}

}  // namespace gradmesh
