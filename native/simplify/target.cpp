#include "simplify/target.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace gradmesh {
namespace {

constexpr double first_epsilon = 0.01, smallest_epsilon = 1e-4;
/// The largest ratio between the epsilon that the search ends with and an epsilon that is too
/// small.
constexpr double precision = 1.05;

/// Tries one epsilon after another and remembers the best mesh.
class TargetSearch {
 public:
  TargetSearch(const Problem& problem, const Method& method, StopWatch& watch)
      : problem_(problem), method_(method), watch_(watch), target_(problem.bounds.target.value()) {}

  Candidate run() {
    double enough = first_epsilon;
    while (!reaches(enough) && enough < 1 && !is_over()) enough = std::min(1.0, 2 * enough);
    double too_small = enough / 2;
    if (enough == first_epsilon)
      while (too_small > smallest_epsilon && !is_over() && reaches(too_small)) {
        enough = too_small;
        too_small /= 2;
      }
    while (enough > precision * too_small && !is_over()) {
      const double between = std::sqrt(enough * too_small);
      (reaches(between) ? enough : too_small) = between;
    }
    return *std::move(best_);
  }

 private:
  bool is_over() const { return watch_.reason() != StopWatch::Reason::none; }

  /// Runs the method with this epsilon. Returns true if that reaches the target.
  bool reaches(double epsilon) {
    problem_.bounds.epsilon = epsilon;
    Candidate found = method_.run(problem_, watch_);
    const int left = found.counts()[target_.what];
    const bool reached = left <= target_.most;
    if (!best_ || is_better(found, left)) {
      best_ = std::move(found);
      left_ = left;
    }
    return reached;
  }

  bool is_better(const Candidate& found, int left) const {
    const bool reached = left <= target_.most;
    if (reached != (left_ <= target_.most)) return reached;
    return reached ? found.error < best_->error : left < left_;
  }

  Problem problem_;
  const Method& method_;
  StopWatch& watch_;
  const Target target_;
  std::optional<Candidate> best_;
  /// How much of what is counted the best mesh has.
  int left_ = 0;
};

}  // namespace

Count what_is_counted(const SimplifyOptions& options, Count otherwise) {
  if (options.handles.has_value() + options.patches.has_value() + options.ratio.has_value() > 1)
    throw std::invalid_argument(
        "a target is a number of handles, a number of patches or a ratio, and one of these only.");
  if (options.handles && options.count == Count::patches)
    throw std::invalid_argument("a number of handles is no target where patches are counted.");
  if (options.patches && options.count == Count::handles)
    throw std::invalid_argument("a number of patches is no target where handles are counted.");
  if (options.handles) return Count::handles;
  if (options.patches) return Count::patches;
  if (options.count) return *options.count;
  return options.method == simplest ? otherwise : method_named(options.method).count;
}

std::optional<Target> target_of(const SimplifyOptions& options, const Mesh& mesh) {
  const Count what = what_is_counted(options);
  if (!options.has_target()) return std::nullopt;
  if (method_named(options.method).merges_named_edges)
    throw std::invalid_argument("the method manual has no target: it merges the edges named.");
  if (options.handles && *options.handles < 1)
    throw std::invalid_argument("the number of handles must be at least 1.");
  if (options.patches && *options.patches < 1)
    throw std::invalid_argument("the number of patches must be at least 1.");
  if (options.ratio && !(*options.ratio > 0 && *options.ratio <= 1))
    throw std::invalid_argument("the ratio must be above 0 and at most 1.");
  if (options.handles) return Target{what, *options.handles};
  if (options.patches) return Target{what, *options.patches};
  return Target{what, std::max(1, int(*options.ratio * counts_of(mesh)[what]))};
}

Candidate search_for_target(const Problem& problem, const Method& method, StopWatch& watch) {
  return TargetSearch(problem, method, watch).run();
}

}  // namespace gradmesh
