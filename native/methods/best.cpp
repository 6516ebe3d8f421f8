#include "methods/best.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include "methods/edges.h"
#include "methods/packing.h"
#include "methods/patch_set.h"
#include "methods/plainer.h"
#include "pricing/parallel_trials.h"

namespace gradmesh {
namespace {

/// Steps of the fit after a set of regions was merged, after one region was merged, and of the
/// whole mesh.
constexpr int steps_for_set = 4, steps_for_one = 5, steps_at_rest = 3;

struct Candidate {
  Region region;
  /// Its patches, how many are saved, and by how much the error rises where it alone is merged.
  PackingItem item;
};

Candidate candidate(const Mesh& mesh, const RegionPrice& r) {
  Candidate c{r.region, {PatchSet(mesh.face_slots()), r.size() - 1, r.error}};
  for (const Face patch : r.patches) c.item.patches.add(patch);
  return c;
}

/// Returns the items, in their order, that do not overlap those taken before, as long as they cost
/// at most gamma together.
Packing greedy_packing(const std::vector<PackingItem>& items, std::size_t face_slots,
                       double gamma) {
  Packing chosen;
  PatchSet taken(face_slots);
  double sum = 0;
  for (int i = 0; i < int(items.size()); ++i) {
    const PackingItem& item = items[std::size_t(i)];
    if (sum + item.price > gamma || taken.overlaps(item.patches)) continue;
    sum += item.price;
    taken.add(item.patches);
    chosen.push_back(i);
  }
  return chosen;
}

/// Returns the regions that save the most patches for at most gamma together. `candidates` are in
/// the order in which a greedy choice takes them.
std::vector<Region> best_regions(const std::vector<Candidate>& candidates, std::size_t face_slots,
                                 double gamma) {
  constexpr int most_nodes = 200;
  std::vector<PackingItem> items;
  for (const Candidate& c : candidates) {
    items.push_back(c.item);
    // Fits can lower the error below what it was, which buys nothing that is not in it already.
    items.back().price = std::max(0.0, c.item.price);
  }
  const Packing start = greedy_packing(items, face_slots, gamma);
  std::vector<Region> regions;
  for (const int i : best_packing(items, gamma, start, most_nodes).items)
    regions.push_back(candidates[std::size_t(i)].region);
  return regions;
}

std::vector<Face> all_faces(const Mesh& mesh) {
  std::vector<Face> faces;
  for (const Face f : mesh.faces()) faces.push_back(f);
  return faces;
}

/// Prices of regions, fitted, of a mesh of which parts change.
class FittedPrices {
 public:
  /// Returns the regions of two patches that cost at most `limit`, the cheapest first. A price is
  /// kept until one of the patches changes; one above the limit at which it was found only until
  /// the limit rises.
  std::vector<Candidate> up_to(double limit, FitTrial& trial,
                               const std::function<bool()>& should_stop) {
    const Mesh& mesh = trial.mesh();
    std::vector<Candidate> candidates;
    std::vector<std::size_t> unknown;
    for (const Halfedge edge : inner_edges(mesh)) {
      if (!mesh.is_leaf(edge) || !leaf_across(mesh, edge).valid()) continue;
      const Region region = region_of_edge(mesh, edge);
      const std::vector<Face> patches{mesh.face(edge), mesh.face(mesh[edge].twin)};
      const Known* known = still_known(region, patches, limit, trial);
      if (!known) unknown.push_back(candidates.size());
      candidates.push_back(candidate(mesh, {region, patches, known ? known->price : 2 * limit}));
    }
    ParallelTrials<FitTrial>(trial).for_each(
        unknown.size(), [&](std::size_t) { return should_stop(); },
        [&](FitTrial& own, std::size_t i) {
          Candidate& c = candidates[unknown[i]];
          c.item.price = own.price(c.region, limit);
        });
    for (const std::size_t i : unknown)
      known_[candidates[i].region] = {candidates[i].item.price, limit, trial.changes()};
    std::erase_if(candidates, [&](const Candidate& c) { return c.item.price > limit; });
    std::ranges::stable_sort(candidates, {}, [](const Candidate& c) { return c.item.price; });
    return candidates;
  }

  void forget() { known_.clear(); }

 private:
  struct Known {
    double price, limit;
    /// FitTrial::changes() when the price was found.
    int changes;
  };

  const Known* still_known(const Region& region, const std::vector<Face>& patches, double limit,
                           const FitTrial& trial) const {
    const auto place = known_.find(region);
    if (place == known_.end()) return nullptr;
    const Known& known = place->second;
    if (known.price > known.limit && limit > known.limit) return nullptr;
    const bool stands = std::ranges::all_of(
        patches, [&](Face patch) { return trial.last_change(patch) <= known.changes; });
    return stands ? &known : nullptr;
  }

  std::map<Region, Known> known_;
};

/// A mesh that is merged and fitted in rounds.
class Rounds {
 public:
  Rounds(MergeTrial& from, const FitContext& context, StopWatch& watch)
      : context_(context),
        watch_(watch),
        epsilon_(context.epsilon),
        fork_(from.fork_to_fit(context.target, context.count == Count::handles)) {}

  const Mesh& mesh() const { return fork_->mesh; }
  double error() const { return fork_->trial.error(); }

  /// Merges and fits regions that cost at most gamma together, the best by Eq. 7 first. Returns
  /// true if that leaves some room below epsilon; otherwise nothing is merged.
  bool begin(const std::vector<RegionPrice>& regions, double gamma) {
    std::vector<Candidate> candidates;
    for (const RegionPrice& r : regions) candidates.push_back(candidate(mesh(), r));
    const double omega = context_.omega, patches = mesh().face_count();
    std::ranges::stable_sort(candidates, std::greater{}, [&](const Candidate& c) {
      return omega * (c.item.saved + 1) / patches - (1 - omega) * c.item.price / gamma;
    });
    // What is left goes to the rounds, which see prices as they are once all is fitted.
    constexpr double share = 0.75;
    return fork_->trial.try_and_fit(best_regions(candidates, mesh().face_slots(), gamma),
                                    share * context_.share * epsilon_, steps_for_set);
  }

  void fit(int steps) { fork_->trial.improve(all_faces(mesh()), steps); }

  /// Runs rounds until nothing more helps. Returns the best mesh that keeps to epsilon as written.
  std::optional<FittedMesh> run() {
    keep();
    for (bool at_rest = false; !should_stop();) {
      if (round()) {
        fit(1);
        at_rest = false;
      } else if (!at_rest) {
        fit(steps_at_rest);
        prices_.forget();
        at_rest = true;
      } else {
        break;
      }
      keep();
    }
    if (context_.count == Count::handles) make_plainer();
    return std::move(best_);
  }

 private:
  bool should_stop() { return watch_.should_stop({rounds_, rounds_ + 1, patches_, error_}); }

  /// Merges as many of the cheapest regions as keep to the limit together, or else one. Returns
  /// true if something was merged.
  bool round() {
    ++rounds_;
    FitTrial& trial = fork_->trial;
    const double limit = context_.share * limit_, room = limit - error();
    if (room <= 0) return false;
    // Prices are of fits of single patches; together with their neighbours they can do better.
    constexpr double most = 2, too_much = 3, too_little = 0.1, shrink = 0.4;
    const std::vector<Candidate> candidates =
        prices_.up_to(most * room, trial, [&] { return should_stop(); });
    std::size_t last_size = 0;
    for (double share = too_much; share > too_little && !should_stop(); share *= shrink) {
      const auto chosen = best_regions(candidates, mesh().face_slots(), share * room);
      if (chosen.empty() || chosen.size() == std::exchange(last_size, chosen.size())) continue;
      if (trial.try_and_fit(chosen, limit, steps_for_set)) return true;
    }
    constexpr std::size_t tried_alone = 3;
    for (std::size_t i = 0; i < std::min(tried_alone, candidates.size()) && !should_stop(); ++i)
      if (trial.try_and_fit({candidates[i].region}, limit, steps_for_one)) return true;
    return false;
  }

  void make_plainer() {
    const auto keeps = [&](const Mesh& mesh) { return context_.written(mesh).keeps; };
    Plainer plainer(fork_->trial, *context_.target, keeps, [&] { return should_stop(); });
    while (plainer.make_step(limit_)) keep();
  }

  /// Remembers the mesh if it keeps to epsilon as it will be written. The error that writing adds
  /// is kept free below epsilon from now on.
  void keep() {
    const FitContext::Written written = context_.written(mesh());
    limit_ = epsilon_ - std::max(0.0, written.error - error());
    if (!written.keeps) return;
    best_ = {mesh(), error()};
    patches_ = mesh().face_count();
    error_ = written.error;
  }

  const FitContext& context_;
  StopWatch& watch_;
  const double epsilon_;
  double limit_ = epsilon_;
  std::unique_ptr<FitTrial::Fork> fork_;
  FittedPrices prices_;
  std::optional<FittedMesh> best_;
  std::size_t rounds_ = 0;
  /// Patches and error of the best mesh so far, for `watch_`.
  int patches_ = fork_->mesh.face_count();
  double error_ = fork_->trial.error();
};

/// Returns the mesh with the most regions merged, by the sum of their prices, that keeps to epsilon
/// once fitted.
std::unique_ptr<Rounds> beyond_epsilon(MergeTrial& start, const std::vector<RegionPrice>& regions,
                                       const FitContext& context, StopWatch& watch) {
  constexpr int tries = 4;
  std::unique_ptr<Rounds> best;
  double enough = start.epsilon(), too_much = 0;
  for (int i = 0; i < tries; ++i) {
    if (watch.should_stop({std::size_t(i), tries, start.mesh().face_count(), start.error()})) break;
    const double gamma = too_much == 0 ? 2 * enough : std::sqrt(enough * too_much);
    auto next = std::make_unique<Rounds>(start, context, watch);
    if (next->begin(regions, gamma)) {
      enough = gamma;
      if (!best || next->mesh().face_count() <= best->mesh().face_count()) best = std::move(next);
    } else {
      too_much = gamma;
    }
  }
  return best;
}

}  // namespace

std::optional<FittedMesh> merge_and_fit(MergeTrial& start, MergeTrial& merged,
                                        const std::vector<RegionPrice>& regions,
                                        const FitContext& context, StopWatch& watch) {
  const std::unique_ptr<Rounds> rounds = beyond_epsilon(start, regions, context, watch);
  const bool goes_on = rounds && rounds->mesh().face_count() <= merged.mesh().face_count();
  std::optional<FittedMesh> best = goes_on ? rounds->run() : fit(merged, context, watch);
  if (context.count == Count::handles) return best;
  if (!best || best->mesh.face_count() == start.mesh().face_count()) return std::nullopt;
  return best;
}

std::optional<FittedMesh> fit(MergeTrial& merged, const FitContext& context, StopWatch& watch) {
  Rounds rounds(merged, context, watch);
  rounds.fit(steps_for_set);
  return rounds.run();
}

std::vector<double> fitted_prices(FitTrial& trial, const std::vector<RegionPrice>& regions,
                                  double limit, StopWatch& watch) {
  std::vector<double> prices;
  for (const RegionPrice& r : regions) prices.push_back(r.error);
  const int patches = trial.mesh().face_count();
  ParallelTrials<FitTrial>(trial).for_each(
      regions.size(),
      [&](std::size_t done) {
        return watch.should_stop({done, regions.size(), patches, trial.error()});
      },
      [&](FitTrial& own, std::size_t i) {
        prices[i] = std::min(prices[i], own.price(regions[i].region, limit));
      });
  return prices;
}

}  // namespace gradmesh
