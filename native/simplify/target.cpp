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
  TargetSearch(const Mesh& mesh, const RunOptions& options, int patches)
      : mesh_(mesh), options_(options), patches_(patches), budget_(options.time_budget) {
    options_.patches.reset();
    options_.ratio.reset();
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
  /// Simplifies with this epsilon. Returns true if at most `patches_` patches are left.
  bool reaches(double epsilon) {
    options_.epsilon = epsilon;
    // A run that begins before the watch ends the search may take only the time that is left.
    if (budget_ > 0) options_.time_budget = std::max(budget_ - watch_.seconds(), 1e-3);
    Mesh mesh = mesh_;
    SimplifyResult result = gradmesh::simplify(mesh, options_);
    const Stopped stopped = result.stopped;
    over_ = stopped == Stopped::budget || stopped == Stopped::cancelled;
    const int evaluations = best_.evaluations + result.evaluations;
    const bool reached = result.patches_after <= patches_;
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
    const bool reached = result.patches_after <= patches_, had = best_.patches_after <= patches_;
    if (reached != had) return reached;
    if (reached) return result.error < best_.error;
    return result.patches_after < best_.patches_after;
  }

  const Mesh& mesh_;
  RunOptions options_;
  const int patches_;
  const double budget_;
  StopWatch watch_{0, {}};
  PriceTable analysis_;
  bool over_ = false, found_ = false;
  SimplifyResult best_;
  Mesh best_mesh_;
};

}  // namespace

std::optional<int> target_patches(const SimplifyOptions& options, int patches_before) {
  if (options.patches && options.ratio)
    throw std::invalid_argument("a target is a number of patches or a ratio, not both.");
  if (!options.patches && !options.ratio) return std::nullopt;
  if (method_named(options.method).merges_named_edges)
    throw std::invalid_argument("the method manual has no target: it merges the edges named.");
  if (options.patches && *options.patches < 1)
    throw std::invalid_argument("the number of patches must be at least 1.");
  if (options.ratio && !(*options.ratio > 0 && *options.ratio <= 1))
    throw std::invalid_argument("the ratio must be above 0 and at most 1.");
  if (options.patches) return options.patches;
  return std::max(1, int(*options.ratio * patches_before));
}

SimplifyResult simplify_to_target(Mesh& mesh, const RunOptions& options, int patches) {
  return TargetSearch(mesh, options, patches).run(mesh);
}

}  // namespace gradmesh
