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
  TargetSearch(const Mesh& mesh, const RunOptions& options, const Target& target)
      : mesh_(mesh), options_(options), target_(target), budget_(options.time_budget) {
    options_.handles.reset();
    options_.patches.reset();
    options_.ratio.reset();
    options_.count = target.what;
    // Each price is found only once for all values of epsilon.
    if (!options_.analysis) options_.analysis = &analysis_;
    // A device that has failed once is not tried again.
    options_.device_lost = [this, told = options.device_lost](const DeviceError& error) {
      options_.device = nullptr;
      if (told) told(error);
    };
  }

  SimplifyResult run(Mesh& mesh) {
    double enough = first_epsilon;
    while (!reaches(enough) && enough < 1 && !over_) enough = std::min(1.0, 2 * enough);
    double too_small = enough / 2;
    if (enough == first_epsilon)
      while (too_small > smallest_epsilon && !over_ && reaches(too_small)) {
        enough = too_small;
        too_small /= 2;
      }
    while (enough > precision * too_small && !over_) {
      const double between = std::sqrt(enough * too_small);
      (reaches(between) ? enough : too_small) = between;
    }
    mesh = std::move(best_mesh_);
    best_.seconds.total = watch_.seconds();
    return best_;
  }

 private:
  /// Simplifies with this epsilon. Returns true if that reaches the target.
  bool reaches(double epsilon) {
    options_.epsilon = epsilon;
    // A run that begins before the watch ends the search may take only the time that is left.
    if (budget_ > 0) options_.time_budget = std::max(budget_ - watch_.seconds(), 1e-3);
    Mesh mesh = mesh_;
    SimplifyResult result = gradmesh::simplify(mesh, options_);
    const Stopped stopped = result.stopped;
    over_ = stopped == Stopped::budget || stopped == Stopped::cancelled;
    const int evaluations = best_.evaluations + result.evaluations;
    const bool reached = has_reached(result);
    if (!found_ || is_better(result)) {
      best_ = std::move(result);
      best_mesh_ = std::move(mesh);
      found_ = true;
    }
    best_.evaluations = evaluations;
    if (over_) best_.stopped = stopped;
    return reached;
  }

  bool is_better(const SimplifyResult& result) const {
    const bool reached = has_reached(result);
    if (reached != has_reached(best_)) return reached;
    if (reached) return result.error < best_.error;
    return left(result) < left(best_);
  }
  static MeshCounts counts(const SimplifyResult& result) {
    return {result.handles_after, result.patches_after};
  }
  int left(const SimplifyResult& result) const { return counts(result)[target_.what]; }
  bool has_reached(const SimplifyResult& result) const {
    return target_.is_reached(counts(result));
  }

  const Mesh& mesh_;
  RunOptions options_;
  const Target target_;
  const double budget_;
  StopWatch watch_{0, {}};
  PriceTable analysis_;
  bool over_ = false, found_ = false;
  SimplifyResult best_;
  Mesh best_mesh_;
};

}  // namespace

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

SimplifyResult simplify_to_target(Mesh& mesh, const RunOptions& options, const Target& target) {
  return TargetSearch(mesh, options, target).run(mesh);
}

}  // namespace gradmesh
