#include "methods/best/best.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <utility>

#include "methods/best/handle_drops.h"
#include "methods/merging/edges.h"
#include "methods/merging/gqe.h"
#include "methods/merging/merging.h"
#include "methods/merging/packing.h"
#include "methods/merging/patch_set.h"
#include "metric/detail_errors.h"
#include "pricing/parallel_trials.h"

namespace gradmesh {
namespace {

/// Steps of the fit after a set of regions was merged, after one region was merged, and of the
/// whole mesh.
constexpr int steps_for_set = 4, steps_for_one = 5, steps_at_rest = 3;

/// A region that may be merged.
struct Choice {
  Region region;
  /// Its patches, how many are saved, and by how much the error rises where it alone is merged.
  PackingItem item;
};

Choice choice_of(const Mesh& mesh, const RegionPrice& r) {
  Choice c{r.region, {PatchSet(mesh.face_slots()), r.size() - 1, r.error}};
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

/// Returns the regions that save the most patches for at most gamma together. `choices` are in
/// the order in which a greedy choice takes them.
std::vector<Region> best_regions(const std::vector<Choice>& choices, std::size_t face_slots,
                                 double gamma) {
  constexpr int most_nodes = 200;
  std::vector<PackingItem> items;
  for (const Choice& c : choices) {
    items.push_back(c.item);
    // Fits can lower the error below what it was, which buys nothing that is not in it already.
    items.back().price = std::max(0.0, c.item.price);
  }
  const Packing start = greedy_packing(items, face_slots, gamma);
  std::vector<Region> regions;
  for (const int i : best_packing(items, gamma, start, most_nodes).items)
    regions.push_back(choices[std::size_t(i)].region);
  return regions;
}

std::vector<Face> all_faces(const Mesh& mesh) {
  std::vector<Face> faces;
  for (const Face f : mesh.faces()) faces.push_back(f);
  return faces;
}

/// Adds to `spared` the faces that are seen in the windows whose errors of details are above the
/// bound, as they are painted in `seen`. Returns true if there are any that were not spared yet.
bool spare_harmed(const Plane& details, double bound, const Raster<std::uint32_t, 1>& seen,
                  std::set<Face>& spared) {
  const std::size_t before = spared.size();
  for (int y = 0; y < details.height; ++y)
    for (int x = 0; x < details.width; ++x)
      if (*details.at(x, y) > bound)
        for_each_run(seen, detail_window(x, y).clipped(seen.window()),
                     [&](Window, TopFace top) { spared.insert(top.face()); });
  return spared.size() > before;
}

/// Prices of regions, fitted, of a mesh of which parts change.
class FittedPrices {
 public:
  /// Returns the regions of two patches that cost at most `limit`, the cheapest first. A price is
  /// kept until one of the patches changes; one above the limit at which it was found only until
  /// the limit rises. Those with a patch that is spared are left out.
  std::vector<Choice> up_to(double limit, FitTrial& trial, const std::set<Face>& spared,
                            const std::function<bool()>& should_stop) {
    const Mesh& mesh = trial.mesh();
    std::vector<Choice> choices;
    std::vector<std::size_t> unknown;
    for (const Halfedge edge : inner_edges(mesh)) {
      if (!mesh.is_leaf(edge) || !leaf_across(mesh, edge).valid()) continue;
      const Region region = region_of_edge(mesh, edge);
      const std::vector<Face> patches{mesh.face(edge), mesh.face(mesh[edge].twin)};
      if (spared.contains(patches[0]) || spared.contains(patches[1])) continue;
      const Known* known = still_known(region, patches, limit, trial);
      if (!known) unknown.push_back(choices.size());
      choices.push_back(choice_of(mesh, {region, patches, known ? known->price : 2 * limit}));
    }
    ParallelTrials<FitTrial>(trial).for_each(
        unknown.size(), [&](std::size_t) { return should_stop(); },
        [&](FitTrial& own, std::size_t i) {
          Choice& c = choices[unknown[i]];
          c.item.price = own.price(c.region, limit);
        });
    for (const std::size_t i : unknown)
      known_[choices[i].region] = {choices[i].item.price, limit, trial.changes()};
    std::erase_if(choices, [&](const Choice& c) { return c.item.price > limit; });
    std::ranges::stable_sort(choices, {}, [](const Choice& c) { return c.item.price; });
    return choices;
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

/// How far rounds go.
struct Goal {
  /// What is made few.
  Count count = Count::patches;
  /// The share of epsilon up to which regions are merged.
  double share = 1;
};

/// A mesh that is merged and fitted in rounds.
class Rounds {
 public:
  Rounds(MergeTrial& from, const Problem& problem, Goal goal, StopWatch& watch)
      : problem_(problem),
        goal_(goal),
        watch_(watch),
        fork_(from.fork_to_fit(goal.count == Count::handles)) {}

  const Mesh& mesh() const { return fork_->mesh; }
  double error() const { return fork_->trial.error(); }

  /// Merges and fits regions that cost at most gamma together, the best by Eq. 7 first. Returns
  /// true if that leaves some room below epsilon; otherwise nothing is merged.
  bool begin(const std::vector<RegionPrice>& regions, double gamma) {
    std::vector<Choice> choices;
    for (const RegionPrice& r : regions) choices.push_back(choice_of(mesh(), r));
    const double omega = problem_.options.omega, patches = mesh().face_count();
    std::ranges::stable_sort(choices, std::greater{}, [&](const Choice& c) {
      return omega * (c.item.saved + 1) / patches - (1 - omega) * c.item.price / gamma;
    });
    // What is left goes to the rounds, which see prices as they are once all is fitted.
    constexpr double share = 0.75;
    return fork_->trial.try_and_fit(best_regions(choices, mesh().face_slots(), gamma),
                                    share * goal_.share * problem_.bounds.epsilon, steps_for_set);
  }

  void fit(int steps) { fork_->trial.improve(all_faces(mesh()), steps); }

  /// Returns the mesh of now if it breaks the bounds as written, else null.
  const Candidate* broke() const { return broke_ ? &*broke_ : nullptr; }

  /// Runs rounds until nothing more helps. Returns the best mesh that keeps to the bounds as
  /// written.
  std::optional<Candidate> run() {
    if (!keep()) {
      // What merging has lost of small parts and details no rounds bring back, if a fit does not.
      fit(steps_at_rest);
      if (!keep()) return std::nullopt;
    }
    for (bool at_rest = false; !should_stop();) {
      if (round()) {
        fit(1);
        at_rest = false;
      } else if (!at_rest) {
        fit(steps_at_rest);
        prices_.forget();
        at_rest = true;
      } else if (!go_back_and_spare()) {
        break;
      } else {
        at_rest = false;
      }
      keep();
    }
    go_back();
    if (goal_.count == Count::handles) drop_handles();
    return std::move(best_);
  }

 private:
  bool should_stop() { return watch_.should_stop({rounds_, rounds_ + 1, patches_, error_}); }

  /// Merges as many of the cheapest regions as keep to the limit together, or else one. Returns
  /// true if something was merged.
  bool round() {
    ++rounds_;
    FitTrial& trial = fork_->trial;
    const double limit = goal_.share * limit_, room = limit - error();
    if (room <= 0) return false;
    // Prices are of fits of single patches; together with their neighbours they can do better.
    constexpr double most = 2, too_much = 3, too_little = 0.1, shrink = 0.4;
    const std::vector<Choice> choices =
        prices_.up_to(most * room, trial, spared_, [&] { return should_stop(); });
    std::size_t last_size = 0;
    for (double share = too_much; share > too_little && !should_stop(); share *= shrink) {
      const auto chosen = best_regions(choices, mesh().face_slots(), share * room);
      if (chosen.empty() || chosen.size() == std::exchange(last_size, chosen.size())) continue;
      if (trial.try_and_fit(chosen, limit, steps_for_set)) return true;
    }
    constexpr std::size_t tried_alone = 3;
    for (std::size_t i = 0; i < std::min(tried_alone, choices.size()) && !should_stop(); ++i)
      if (trial.try_and_fit({choices[i].region}, limit, steps_for_one)) return true;
    return false;
  }

  void drop_handles() {
    const auto keeps = [&](const Mesh& mesh) { return problem_.measure(mesh).keeps; };
    HandleDrops drops(fork_->trial, keeps, [&] { return should_stop(); });
    while (drops.drop_some(limit_)) keep();
  }

  /// Goes back to the best mesh that keeps to the bounds if later rounds have broken them for good.
  void go_back() {
    if (broke_) fork_->trial.go_back(kept_);
    prices_.forget();
  }

  /// Goes back, and leaves alone from then on what broke the bound of details, which no price
  /// knows. Returns false if that is nothing new.
  bool go_back_and_spare() {
    if (!broke_ || !problem_.bounds.detail) return false;
    const bool spares = spare_harmed(broke_->measured->details(), *problem_.bounds.detail,
                                     kept_.error->painting.top, spared_);
    go_back();
    return spares;
  }

  /// Remembers the mesh if it keeps to the bounds as it will be written, and returns true then. The
  /// error that writing adds is kept free below epsilon from now on.
  bool keep() {
    Candidate written = problem_.measure(mesh());
    limit_ = problem_.bounds.epsilon - std::max(0.0, written.error - error());
    if (!written.keeps) {
      broke_ = std::move(written);
      return false;
    }
    patches_ = mesh().face_count();
    error_ = written.error;
    best_ = std::move(written);
    best_->error_added_up = error();
    broke_.reset();
    kept_ = fork_->trial.state();
    return true;
  }

  const Problem& problem_;
  const Goal goal_;
  StopWatch& watch_;
  double limit_ = problem_.bounds.epsilon;
  std::unique_ptr<FitTrial::Fork> fork_;
  FittedPrices prices_;
  std::optional<Candidate> best_;
  /// The state of the trial with that mesh, and the mesh of now if it breaks the bounds.
  FitTrial::State kept_;
  std::optional<Candidate> broke_;
  /// Patches that are not merged, as their details were harmed.
  std::set<Face> spared_;
  std::size_t rounds_ = 0;
  /// Patches and error of the best mesh so far, for `watch_`.
  int patches_ = fork_->mesh.face_count();
  double error_ = fork_->trial.error();
};

/// Merges and fits, from a mesh of which nothing has been merged yet.
class Best {
 public:
  Best(const Problem& problem, StopWatch& watch)
      : problem_(problem),
        watch_(watch),
        merged_(problem.pricing_trial()),
        start_(merged_->trial.fork()),
        regions_(price_regions(merged_->trial, problem.prices(), merged_->trial.room(), watch)) {}

  /// Returns the mesh with the fewest patches, and of several the one with the smallest error.
  Candidate fewest_patches() {
    MergeTrial& trial = merged_->trial;
    select_gqe(trial, regions_, {omega(), false}, watch_);
    std::optional<Candidate> best = rounds_from(trial, regions_, {})->run();
    if (best && best->mesh.face_count() == problem_.mesh().face_count()) best.reset();
    Candidate merged = merge_what_fits(problem_, trial, [&](MergeTrial& t, PriceTable& prices) {
      merge_by_gqe(t, prices, {omega(), false}, watch_);
    });
    const int fewest = merged.mesh.face_count();
    if (best && best->mesh.face_count() > fewest) best = rounds_at(trial, {})->run();
    if (!best || best->mesh.face_count() > fewest) return merged;
    const bool as_many = best->mesh.face_count() == fewest;
    return as_many && merged.error <= best->error ? merged : *std::move(best);
  }

  /// Returns the blocks that leave least to handle: of all the patches that can be merged, or of
  /// fewer, which leaves more of epsilon for straight sides.
  Candidate least_effort() {
    std::optional<Candidate> best;
    const int before = problem_.measure(problem_.mesh()).counts().handles;
    for (const double share : {1.0, 0.5}) {
      std::optional<Candidate> found = least_effort_with({Count::handles, share});
      // Details were harmed, however few patches were left alone for them: that is not for lack of
      // epsilon.
      if (!found) break;
      if (found->counts().handles >= before) continue;
      if (!best || found->effort() < best->effort()) best = std::move(found);
    }
    return best ? *std::move(best) : problem_.unchanged();
  }

 private:
  double omega() const { return problem_.options.omega; }

  /// Returns the best blocks of one share. Prices do not know the bound of details, least of all
  /// where a person's weights raise them: where that leaves nothing, it is tried again without the
  /// regions of the patches whose details were harmed.
  std::optional<Candidate> least_effort_with(Goal goal) {
    constexpr int tries = 6;
    const auto start = start_->trial.state().error;
    std::set<Face> spared;
    std::vector<RegionPrice> regions = regions_;
    for (int i = 0; i < tries; ++i) {
      const auto merged = start_->trial.fork();
      merged->trial.lower_epsilon(goal.share * problem_.bounds.epsilon);
      select_gqe(merged->trial, regions, {omega(), false}, watch_);
      const std::unique_ptr<Rounds> rounds = rounds_from(merged->trial, regions, goal);
      if (std::optional<Candidate> found = rounds->run()) return found;
      const Candidate* const broke = rounds->broke();
      if (!broke || !problem_.bounds.detail ||
          !spare_harmed(broke->measured->details(), *problem_.bounds.detail, start->painting.top,
                        spared))
        break;
      std::erase_if(regions, [&](const RegionPrice& r) {
        return std::ranges::any_of(r.patches, [&](Face f) { return spared.contains(f); });
      });
    }
    return std::nullopt;
  }

  /// Returns rounds from where gqe ends, or from beyond if that leaves no more patches. `merged` is
  /// the mesh that gqe merged of these regions.
  std::unique_ptr<Rounds> rounds_from(MergeTrial& merged, const std::vector<RegionPrice>& regions,
                                      Goal goal) {
    std::unique_ptr<Rounds> rounds = beyond_epsilon(regions, goal);
    const bool goes_on = rounds && rounds->mesh().face_count() <= merged.mesh().face_count();
    return goes_on ? std::move(rounds) : rounds_at(merged, goal);
  }

  std::unique_ptr<Rounds> rounds_at(MergeTrial& merged, Goal goal) {
    auto rounds = std::make_unique<Rounds>(merged, problem_, goal, watch_);
    rounds->fit(steps_for_set);
    return rounds;
  }

  /// Returns the mesh with the most regions merged, by the sum of their prices, that keeps to
  /// epsilon once fitted.
  std::unique_ptr<Rounds> beyond_epsilon(const std::vector<RegionPrice>& regions, Goal goal) {
    constexpr int tries = 4;
    MergeTrial& start = start_->trial;
    std::unique_ptr<Rounds> best;
    double enough = start.epsilon(), too_much = 0;
    for (int i = 0; i < tries; ++i) {
      if (watch_.should_stop({std::size_t(i), tries, start.mesh().face_count(), start.error()}))
        break;
      const double gamma = too_much == 0 ? 2 * enough : std::sqrt(enough * too_much);
      auto next = std::make_unique<Rounds>(start, problem_, goal, watch_);
      if (next->begin(regions, gamma)) {
        enough = gamma;
        if (!best || next->mesh().face_count() <= best->mesh().face_count()) best = std::move(next);
      } else {
        too_much = gamma;
      }
    }
    return best;
  }

  const Problem& problem_;
  StopWatch& watch_;
  /// The mesh that gqe merges, and the mesh before anything is merged.
  const std::unique_ptr<MergeTrial::Fork> merged_, start_;
  const std::vector<RegionPrice> regions_;
};

}  // namespace

Candidate merge_and_fit(const Problem& problem, StopWatch& watch) {
  Best best(problem, watch);
  const bool drops_handles =
      problem.count == Count::handles && problem.mesh().color_model() == ColorModel::bilinear;
  return drops_handles ? best.least_effort() : best.fewest_patches();
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
