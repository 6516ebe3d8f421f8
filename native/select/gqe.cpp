#include "select/gqe.h"

#include <algorithm>
#include <numeric>

namespace gradmesh {
namespace {

constexpr int halvings = 10;

struct Candidate {
  Region region;
  std::vector<Face> faces;
  double error;
};

using Ranking = std::vector<int>;

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
    const int before = trial_.mesh().face_count();
    best_patches_ = before;
    double low = 0, high = 2 * trial_.epsilon();
    for (int i = 0; i < halvings; ++i) {
      // A run that is out of time still takes the first outcome that keeps to epsilon.
      if (watch.should_stop({std::size_t(i), halvings, best_patches_, best_error_}) &&
          best_patches_ < before)
        break;
      const double gamma = 0.5 * (low + high);
      (try_gamma(gamma) ? low : high) = gamma;
    }
    trial_.merge_all(best_);
  }

 private:
  /// Whether some independent set within gamma keeps to epsilon.
  bool try_gamma(double gamma) {
    bool fits = consider(independent_set(ranking(gamma), gamma));
    if (options_.look_ahead)
      fits = consider(independent_set(ranking_of_pairs(gamma), gamma)) || fits;
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

  /// The candidates of the ranking, each if it overlaps none before it and their prices together
  /// stay within gamma.
  std::vector<const Candidate*> independent_set(const Ranking& order, double gamma) const {
    std::vector<bool> taken(trial_.mesh().face_slots(), false);
    std::vector<const Candidate*> chosen;
    double sum = 0;
    for (const int i : order) {
      const Candidate& c = candidates_[i];
      const bool overlaps = std::ranges::any_of(c.faces, [&](Face f) { return taken[f.value]; });
      if (overlaps || sum + c.error > gamma) continue;
      for (const Face f : c.faces) taken[f.value] = true;
      chosen.push_back(&c);
      sum += c.error;
    }
    return chosen;
  }

  /// Whether all of the set keeps to epsilon. Where it does not, since some regions cost more
  /// beside others than alone, those that do are left out.
  bool consider(const std::vector<const Candidate*>& chosen) {
    std::vector<Region> regions;
    for (const Candidate* c : chosen) regions.push_back(c->region);
    const double error = trial_.merge_all(regions);
    const bool fits = error <= trial_.epsilon();
    if (fits) remember(regions, error);
    trial_.undo_all();
    if (fits) return true;

    regions.clear();
    for (const Candidate* c : chosen)
      if (trial_.error() + c->error <= trial_.epsilon() && trial_.try_merge(c->region))
        regions.push_back(c->region);
    remember(regions, trial_.error());
    trial_.undo_all();
    return false;
  }

  /// The mesh is merged as these regions say.
  void remember(const std::vector<Region>& regions, double error) {
    const int patches = trial_.mesh().face_count();
    if (patches > best_patches_ || (patches == best_patches_ && error >= best_error_)) return;
    best_ = regions;
    best_patches_ = patches;
    best_error_ = error;
  }

  MergeTrial& trial_;
  const GqeOptions options_;
  const double patches_;
  std::vector<Candidate> candidates_;
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
