#include "methods/merging/gqe.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <numeric>
#include <optional>
#include <queue>

#include "methods/merging/patch_set.h"
#include "pricing/parallel_trials.h"

namespace gradmesh {
namespace {

constexpr int halvings = 10, sweeps = 20;

struct PricedRegion {
  Region region;
  int size;
  PatchSet patches;
  double error;
};

/// Candidates by their numbers, the best first.
using Ranking = std::vector<int>;

/// Regions to try together.
struct Plan {
  Ranking order;
  /// The independent set that fits into gamma, in that order.
  Ranking chosen;
};

/// The result of a plan.
struct TriedSet {
  std::vector<Region> regions;
  int patches = 0;
  double error = 0;
  /// True if the set as planned kept to epsilon.
  bool fits = false;

  bool is_better_than(const TriedSet& other) const {
    return std::pair(patches, error) < std::pair(other.patches, other.error);
  }
};

/// The candidates taken so far.
class Chosen {
 public:
  explicit Chosen(std::size_t face_slots) : taken_(face_slots) {}

  bool is_free(const PricedRegion& c) const { return !taken_.overlaps(c.patches); }
  void add(const PricedRegion& c) {
    taken_.add(c.patches);
    regions_.push_back(c.region);
  }
  const std::vector<Region>& regions() const { return regions_; }

 private:
  PatchSet taken_;
  std::vector<Region> regions_;
};

/// Ranks the candidates for one gamma and picks the set.
class Planner {
 public:
  /// `patches` and `face_slots` are those of the mesh before anything is merged.
  Planner(const std::vector<PricedRegion>& candidates, int patches, std::size_t face_slots,
          double omega, double gamma)
      : candidates_(candidates),
        slots_(face_slots),
        patches_(patches),
        omega_(omega),
        gamma_(gamma) {
    // Eq. 7, with size and error as shares of the whole mesh and of gamma.
    const double all = gamma > 0 ? gamma : 1;
    for (const PricedRegion& c : candidates)
      scores_.push_back(omega * c.size / patches_ - (1 - omega) * c.error / all);
    by_score_.resize(candidates.size());
    std::iota(by_score_.begin(), by_score_.end(), 0);
    std::ranges::stable_sort(by_score_, [&](int a, int b) { return scores_[a] > scores_[b]; });
    places_.resize(candidates.size());
    for (std::size_t place = 0; place < by_score_.size(); ++place)
      places_[std::size_t(by_score_[place])] = place;
  }

  Plan by_score() const {
    Plan plan{by_score_, {}};
    Chosen choice(slots_);
    double sum = 0;
    for (const int i : by_score_) take_if_possible(i, choice, sum, plan);
    return plan;
  }

  /// Ranks by Eq. 8: each candidate by the better of its own score and its score with its best
  /// partner; the two of a pair, which score the same, by their own scores. As the set grows
  /// partners are taken and scores fall. A candidate keeps its place in the list of partners and is
  /// ranked anew only when its turn comes and its partner is gone.
  Plan by_pairs() const {
    Plan plan;
    Chosen choice(slots_);
    double sum = 0;
    std::vector<std::size_t> partner(candidates_.size(), 0);
    const auto later = [this](const auto& a, const auto& b) {
      return a.first != b.first ? a.first < b.first
                                : places_[std::size_t(a.second)] > places_[std::size_t(b.second)];
    };
    std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int>>,
                        decltype(later)>
        queue(later);
    for (const int i : by_score_) queue.emplace(with_partner(i, partner[i], choice), i);
    while (!queue.empty()) {
      const auto [score, i] = queue.top();
      queue.pop();
      const double now = with_partner(i, partner[i], choice);
      if (now < score) {
        queue.emplace(now, i);
        continue;
      }
      plan.order.push_back(i);
      take_if_possible(i, choice, sum, plan);
    }
    return plan;
  }

 private:
  void take_if_possible(int i, Chosen& choice, double& sum, Plan& plan) const {
    const PricedRegion& c = candidates_[i];
    if (!choice.is_free(c) || sum + c.error > gamma_) return;
    choice.add(c);
    plan.chosen.push_back(i);
    sum += c.error;
  }

  /// Moves `partner` on to the best free candidate that does not overlap the i-th. Returns the
  /// better of the candidate's own score and that of the pair. The score of a pair is the sum of
  /// both scores less the same share for all pairs.
  double with_partner(int i, std::size_t& partner, const Chosen& choice) const {
    while (partner < by_score_.size() && !is_partner(i, by_score_[partner], choice)) ++partner;
    if (partner == by_score_.size()) return scores_[i];
    // The same sum, to the last bit, for both of a pair.
    return std::max(scores_[i], scores_[i] + scores_[by_score_[partner]] - omega_ / patches_);
  }
  bool is_partner(int i, int other, const Chosen& choice) const {
    return choice.is_free(candidates_[other]) &&
           !candidates_[i].patches.overlaps(candidates_[other].patches);
  }

  const std::vector<PricedRegion>& candidates_;
  const std::size_t slots_;
  const double patches_, omega_, gamma_;
  std::vector<double> scores_;
  Ranking by_score_;
  /// Place of each candidate in `by_score_`.
  std::vector<std::size_t> places_;
};

class Gqe {
 public:
  Gqe(MergeTrial& trial, const std::vector<RegionPrice>& regions, const GqeOptions& options,
      StopWatch& watch)
      : trial_(trial),
        options_(options),
        watch_(watch),
        patches_(trial.mesh().face_count()),
        slots_(trial.mesh().face_slots()) {
    for (const RegionPrice& r : regions) {
      PricedRegion& candidate =
          candidates_.emplace_back(PricedRegion{r.region, r.size(), PatchSet(slots_), r.error});
      for (const Face patch : r.patches) candidate.patches.add(patch);
    }
    best_.patches = patches_;
  }

  void run() {
    if (trial_.measure().local_bound()) leave_out_breakers();
    if (candidates_.empty()) return;
    // The number of patches goes up and down with gamma, which the halvings do not see.
    std::vector<double> gammas;
    for (int i = 1; i <= sweeps; ++i) gammas.push_back(2 * trial_.room() * i / sweeps);
    const std::vector<Plan> plans = plans_for(gammas);

    // Outcomes are compared in the order of the jobs, whichever is done first.
    std::vector<std::optional<TriedSet>> outcomes(1 + plans.size());
    ParallelTrials trials(trial_);
    trials.for_each(
        outcomes.size(), [&](std::size_t done) { return done > 0 && stop(done); },
        [&](MergeTrial& own, std::size_t job) {
          outcomes[job] = job == 0 ? best_of_halvings(own) : outcome(own, plans[job - 1]);
          show(*outcomes[job]);
        });
    const TriedSet* best = nullptr;
    for (const auto& o : outcomes)
      if (o && (!best || o->is_better_than(*best))) best = &*o;
    if (best) trial_.merge(best->regions);
  }

 private:
  /// Leaves out the regions that alone break the local bound, which prices do not show.
  void leave_out_breakers() {
    std::vector<char> keeps(candidates_.size(), true);
    ParallelTrials(trial_).for_each(
        candidates_.size(), [&](std::size_t) { return stop(0); },
        [&](MergeTrial& own, std::size_t i) {
          RegionTrial alone(own, own.mesh());
          keeps[i] = alone.keeps_local_bound(candidates_[i].region, own.epsilon());
        });
    std::vector<PricedRegion> kept;
    for (std::size_t i = 0; i < candidates_.size(); ++i)
      if (keeps[i]) kept.push_back(std::move(candidates_[i]));
    candidates_ = std::move(kept);
  }

  /// Returns the plans for these values of gamma, each set of regions once.
  std::vector<Plan> plans_for(const std::vector<double>& gammas) const {
    std::vector<Plan> plans;
    const auto add = [&](Plan plan) {
      const auto same = [&](const Plan& p) { return p.chosen == plan.chosen; };
      if (std::ranges::none_of(plans, same)) plans.push_back(std::move(plan));
    };
    for (const double gamma : gammas) {
      const Planner planner = planner_for(gamma);
      add(planner.by_score());
      if (options_.look_ahead) add(planner.by_pairs());
    }
    return plans;
  }

  Planner planner_for(double gamma) const {
    return {candidates_, patches_, slots_, options_.omega, gamma};
  }

  /// Returns the best outcome of the paper's search for gamma, which runs on one thread, as each
  /// halving follows from the last.
  TriedSet best_of_halvings(MergeTrial& own) {
    TriedSet best;
    // The last halvings hardly change the set any more.
    std::map<Ranking, bool> tried;
    const auto fits = [&](const Plan& plan) {
      const auto [place, is_new] = tried.try_emplace(plan.chosen);
      if (is_new) {
        const TriedSet found = outcome(own, plan);
        place->second = found.fits;
        if (tried.size() == 1 || found.is_better_than(best)) best = found;
      }
      return place->second;
    };
    double low = 0, high = 2 * own.room();
    for (int i = 0; i < halvings && (i == 0 || !stopped_); ++i) {
      const double gamma = 0.5 * (low + high);
      const Planner planner = planner_for(gamma);
      (fits(planner.by_score()) ? low : high) = gamma;
      if (options_.look_ahead) fits(planner.by_pairs());
    }
    return best;
  }

  /// Merges the set of the plan, mends it, and takes everything back. Returns the outcome.
  TriedSet outcome(MergeTrial& own, const Plan& plan) const {
    TriedSet result;
    const MergeTrial::State start = own.state();
    Chosen choice(own.mesh().face_slots());
    std::vector<Region> planned;
    for (const int i : plan.chosen) planned.push_back(candidates_[i].region);
    result.fits = planned.empty() || own.try_regions(planned);
    if (result.fits)
      for (const int i : plan.chosen) choice.add(candidates_[i]);
    for (const int i : plan.order) {
      const PricedRegion& c = candidates_[i];
      if (choice.is_free(c) && own.error() + c.error <= own.epsilon() &&
          own.try_regions(std::vector{c.region}))
        choice.add(c);
    }
    result.regions = choice.regions();
    result.patches = own.mesh().face_count();
    result.error = own.error();
    own.go_back(start);
    return result;
  }

  /// Returns true if the run is to stop. Called on the thread that started the run.
  bool stop(std::size_t done) {
    const std::lock_guard lock(shown_);
    stopped_ = stopped_ || watch_.should_stop({done, 1 + sweeps, best_.patches, best_.error});
    return stopped_;
  }

  /// Keeps the best outcome so far, for `watch_`.
  void show(const TriedSet& outcome) {
    const std::lock_guard lock(shown_);
    if (outcome.is_better_than(best_)) best_ = outcome;
  }

  MergeTrial& trial_;
  const GqeOptions options_;
  StopWatch& watch_;
  /// Patches of the mesh as it is at first; while trials run, each changes its own mesh.
  const int patches_;
  const std::size_t slots_;
  std::vector<PricedRegion> candidates_;
  std::mutex shown_;
  std::atomic<bool> stopped_ = false;
  TriedSet best_;
};

}  // namespace

void select_gqe(MergeTrial& trial, const std::vector<RegionPrice>& regions,
                const GqeOptions& options, StopWatch& watch) {
  Gqe(trial, regions, options, watch).run();
}

void merge_by_gqe(MergeTrial& trial, PriceTable& analysis, const GqeOptions& options,
                  StopWatch& watch) {
  PriceTable closing;
  for (PriceTable* known = &analysis;; known = &(closing = {})) {
    const std::size_t depth = trial.depth();
    select_gqe(trial, price_regions(trial, *known, trial.room(), watch), options, watch);
    if (trial.depth() == depth) return;
  }
}

}  // namespace gradmesh
