#include "select/gqe.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace gradmesh {
namespace {

constexpr int halvings = 10, sweeps = 20;

struct Candidate {
  Region region;
  std::vector<Face> faces;
  double error;
};

using Ranking = std::vector<int>;

/// Sets that were tried, and whether they kept to epsilon.
using Tried = std::map<std::vector<Region>, bool>;

class Gqe {
 public:
  Gqe(MergeTrial& trial, const std::vector<RegionPrice>& regions, const GqeOptions& options)
      : trial_(trial), options_(options), patches_(trial.mesh().face_count()) {
    for (const RegionPrice& r : regions) {
      Candidate& candidate = candidates_.emplace_back(Candidate{r.region, {}, r.error});
      for (const Halfedge top : region_tops(trial.mesh(), r.region))
        candidate.faces.push_back(trial.mesh().face(top));
    }
  }

  void run(StopWatch& watch) {
    best_patches_ = trial_.mesh().face_count();
    double low = 0, high = 2 * trial_.epsilon();
    for (int i = 0; i < halvings && !stop(i, watch); ++i) {
      const double gamma = 0.5 * (low + high);
      (try_gamma(gamma) ? low : high) = gamma;
    }
    // The number of patches goes up and down with gamma, which the halvings do not see.
    for (int i = 1; i <= sweeps && !stop(halvings + i - 1, watch); ++i)
      try_gamma(2 * trial_.epsilon() * i / sweeps);
    trial_.merge(best_);
  }

 private:
  /// A run that is out of time still takes the first outcome.
  bool stop(int done, StopWatch& watch) const {
    return watch.should_stop({std::size_t(done), halvings + sweeps, best_patches_, best_error_}) &&
           !best_.empty();
  }

  /// Whether the independent set by Eq. 7 within gamma keeps to epsilon.
  bool try_gamma(double gamma) {
    const bool fits = try_ranking(ranking(gamma), gamma, tried_);
    if (options_.look_ahead) try_ranking(ranking_of_pairs(gamma), gamma, tried_by_pairs_);
    return fits;
  }

  /// Eq. 7, with size and error as shares of the whole mesh and of gamma.
  double score(const Candidate& c, double gamma) const {
    return options_.omega * double(c.region.size()) / patches_ -
           (1 - options_.omega) * c.error / gamma;
  }

  /// Candidates by falling score; of equals the one listed first.
  static Ranking sorted(const std::vector<double>& scores) {
    Ranking order(scores.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, [&](int a, int b) { return scores[a] > scores[b]; });
    return order;
  }

  Ranking ranking(double gamma) const {
    std::vector<double> scores;
    for (const Candidate& c : candidates_) scores.push_back(score(c, gamma));
    return sorted(scores);
  }

  /// Eq. 8: each candidate by the better of its own score and its score with its best partner.
  Ranking ranking_of_pairs(double gamma) const {
    const Ranking alone = ranking(gamma);
    std::vector<double> scores(candidates_.size());
    std::vector<bool> mine(trial_.mesh().face_slots(), false);
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      const Candidate& c = candidates_[i];
      scores[i] = score(c, gamma);
      for (const Face f : c.faces) mine[f.value] = true;
      // The score of a pair is the sum of both less the same share for all pairs: the best partner
      // is the best that does not overlap.
      const auto partner = std::ranges::find_if(alone, [&](int other) {
        return std::ranges::none_of(candidates_[other].faces,
                                    [&](Face f) { return mine[f.value]; });
      });
      if (partner != alone.end())
        scores[i] = std::max(
            scores[i], scores[i] + score(candidates_[*partner], gamma) - options_.omega / patches_);
      for (const Face f : c.faces) mine[f.value] = false;
    }
    return sorted(scores);
  }

  /// Merges the independent set of the ranking, mends it, keeps the outcome in mind if it is the
  /// best so far, and takes everything back. Whether the set kept to epsilon as it was.
  bool try_ranking(const Ranking& order, double gamma, Tried& tried) {
    taken_.assign(trial_.mesh().face_slots(), false);
    chosen_.clear();
    double sum = 0;
    for (const int i : order) {
      const Candidate& c = candidates_[i];
      if (!is_free(c) || sum + c.error > gamma) continue;
      choose(c);
      sum += c.error;
    }
    if (const auto known = tried.find(chosen_); known != tried.end()) return known->second;
    const bool fits = chosen_.empty() || trial_.try_merge(chosen_);
    tried.emplace(chosen_, fits);
    if (!fits) {
      taken_.assign(taken_.size(), false);
      chosen_.clear();
    }
    for (const int i : order) {
      const Candidate& c = candidates_[i];
      if (is_free(c) && trial_.error() + c.error <= trial_.epsilon() &&
          trial_.try_merge(std::vector{c.region}))
        choose(c);
    }
    remember();
    trial_.undo_all();
    return fits;
  }

  bool is_free(const Candidate& c) const {
    return std::ranges::none_of(c.faces, [&](Face f) { return taken_[f.value]; });
  }
  void choose(const Candidate& c) {
    for (const Face f : c.faces) taken_[f.value] = true;
    chosen_.push_back(c.region);
  }

  void remember() {
    const int patches = trial_.mesh().face_count();
    const double error = trial_.error();
    if (patches > best_patches_ || (patches == best_patches_ && error >= best_error_)) return;
    best_ = chosen_;
    best_patches_ = patches;
    best_error_ = error;
  }

  MergeTrial& trial_;
  const GqeOptions options_;
  const double patches_;
  std::vector<Candidate> candidates_;
  /// The set at hand: its regions, and the faces they take.
  std::vector<Region> chosen_;
  std::vector<bool> taken_;
  Tried tried_, tried_by_pairs_;
  std::vector<Region> best_;
  int best_patches_ = 0;
  double best_error_ = 0;
};

}  // namespace

void select_gqe(MergeTrial& trial, const std::vector<RegionPrice>& regions,
                const GqeOptions& options, StopWatch& watch) {
  Gqe(trial, regions, options).run(watch);
}

}  // namespace gradmesh
