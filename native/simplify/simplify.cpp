#include "simplify/simplify.h"

#include <stdexcept>

#include "base/error.h"
#include "mesh/build.h"
#include "methods/best/best.h"
#include "simplify/target.h"

namespace gradmesh {
namespace {

void check_suits(const Method& method, const Mesh& mesh) {
  if (const auto why = method.why_not(mesh)) throw InputError(*why);
}

/// Throws InputError if regions of the mesh cannot be merged alone.
void check_has_regions(const Problem& problem) {
  check_suits(method_named(best_method), problem.mesh());
}

Stopped why_stopped(const StopWatch& watch, bool changed) {
  if (watch.reason() == StopWatch::Reason::cancelled) return Stopped::cancelled;
  if (watch.reason() == StopWatch::Reason::budget) return Stopped::budget;
  return changed ? Stopped::done : Stopped::nothing_to_merge;
}

Candidate run(Problem problem, const Method& method, StopWatch& watch) {
  if (!problem.bounds.target) return method.run(problem, watch);
  if (!method.meets_targets) return search_for_target(problem, method, watch);
  problem.bounds.epsilon = 1;
  return method.run(problem, watch);
}

}  // namespace

const char* name(Stopped stopped) {
  switch (stopped) {
    case Stopped::done:
      return "done";
    case Stopped::budget:
      return "budget";
    case Stopped::cancelled:
      return "cancelled";
    case Stopped::nothing_to_merge:
      return "nothing to merge";
  }
  return "";
}

Problem problem_of(std::shared_ptr<const Mesh> mesh, const RunOptions& options) {
  check(options);
  Problem problem(std::move(mesh), options.original, options, options.resolution, options.metric);
  problem.bounds = {options.epsilon, options.max_local_error, options.max_detail_error,
                    target_of(options, problem.mesh())};
  problem.count = what_is_counted(options);
  problem.options = options;
  problem.threads = options.threads;
  problem.rules = options.rules;
  problem.gradient_rules = options.gradient_rules;
  const auto device = [device = options.device] { return device; };
  problem.price_with({options.analysis, device, options.device_lost});
  if (PriceTable* const analysis = options.analysis) {
    const PriceTableKey key = problem.price_key();
    if (analysis->prices.empty()) analysis->key = key;
    if (analysis->key != key)
      throw std::invalid_argument(
          "the analysis is of another mesh, metric, resolution or color model.");
  }
  return problem;
}

SimplifyResult result_of(const Problem& problem, const Method& method, Candidate found) {
  SimplifyResult result;
  static_cast<Candidate&>(result) = std::move(found);
  // A result outlives the run, and a picture is large.
  result.measured.reset();
  result.method = method.name;
  result.frame = problem.frame();
  const MeshCounts before = counts_of(problem.mesh()), after = result.counts();
  result.handles_before = before.handles;
  result.patches_before = before.patches;
  result.handles_after = after.handles;
  result.patches_after = result.mesh.face_count();
  result.error_before = problem.beyond_start({.epsilon = 0}).epsilon;
  result.objects = result.form.object_count();
  result.evaluations = problem.evaluations();
  if (method.needs_prices) result.renderer = problem.renderer();
  return result;
}

SimplifyResult simplify(const Problem& asked, const Method& method, StopWatch& watch) {
  check_suits(method, asked.mesh());
  const Problem problem = method.keeps_rectangle ? asked.as_gradient() : asked;
  const ThreadLimit limit = problem.thread_limit();
  const double begun = watch.seconds();
  problem.trial();
  const double painted = watch.seconds() - begun;
  SimplifyResult result = result_of(problem, method, run(problem, method, watch));
  result.stopped = why_stopped(watch, result.changed);
  const double total = watch.seconds();
  result.seconds = {painted, total - painted, total};
  return result;
}

SimplifyResult simplify(Mesh& mesh, const RunOptions& options) {
  const Problem problem = problem_of(std::make_shared<const Mesh>(mesh), options);
  StopWatch watch = watch_of(options);
  SimplifyResult result = simplify(problem, method_named(options.method), watch);
  if (result.changed) mesh = result.mesh;
  return result;
}

std::vector<EdgePrice> analyze_edges(const Problem& problem, StopWatch& watch) {
  check_has_regions(problem);
  const ThreadLimit limit = problem.thread_limit();
  return price_edges(problem.pricing_trial()->trial, problem.prices(), watch);
}

std::vector<RegionPrice> analyze_regions(const Problem& problem, StopWatch& watch) {
  check_has_regions(problem);
  const ThreadLimit limit = problem.thread_limit();
  return price_regions(problem.pricing_trial()->trial, problem.prices(), problem.bounds.epsilon,
                       watch);
}

std::vector<double> analyze_fits(const Problem& problem, const std::vector<RegionPrice>& regions,
                                 StopWatch& watch) {
  check_has_regions(problem);
  const ThreadLimit limit = problem.thread_limit();
  return fitted_prices(problem.trial()->trial.fork_to_fit()->trial, regions, problem.bounds.epsilon,
                       watch);
}

}  // namespace gradmesh
