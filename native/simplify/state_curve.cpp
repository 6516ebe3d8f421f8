#include "simplify/state_curve.h"

#include <utility>

#include "base/error.h"
#include "methods/method.h"
#include "methods/plain/plain.h"
#include "simplify/options.h"

namespace gradmesh {
namespace {

/// Bounds, and the amount whose bounds they are, if there is one.
struct Rung {
  Bounds bounds;
  std::string amount = "";
};

std::vector<Rung> rungs_of_amounts(MetricKind metric) {
  std::vector<Rung> rungs;
  for (const Amount& amount : all_amounts())
    rungs.push_back({bounds_of(amount, metric), amount.name});
  return rungs;
}

CurveState state_of(const Candidate& written) {
  return {std::make_shared<const Mesh>(written.mesh), written.counts(), written.form.object_count(),
          written.error, written.local_error};
}

/// A curve while it grows.
class Growing {
 public:
  /// The first state is the mesh as it is, which is not written anew.
  Growing(const Problem& problem, const CurveGrown& grown) : grown_(grown) {
    add(problem.unchanged());
  }

  /// Adds a mesh as the next state; one with as many handles as the last takes its place.
  void add(const Candidate& written) {
    CurveState state = state_of(written);
    if (!curve_.states.empty()) {
      const CurveState& last = curve_.states.back();
      if (state.counts.handles > last.counts.handles) return;
      if (state.counts.handles == last.counts.handles) {
        const bool may_go = curve_.states.size() > 1 && !is_marked_;
        if (!may_go || state.error > last.error) return;
        curve_.states.pop_back();
      }
    }
    curve_.states.push_back(std::move(state));
    is_marked_ = false;
    if (grown_) grown_(curve_);
  }

  /// Marks the last state as that of an amount.
  void mark(const std::string& amount) {
    if (amount.empty()) return;
    curve_.marks.push_back({amount, int(curve_.states.size()) - 1});
    is_marked_ = true;
    if (grown_) grown_(curve_);
  }

  StateCurve take() { return std::move(curve_); }

 private:
  const CurveGrown& grown_;
  StateCurve curve_;
  bool is_marked_ = false;
};

/// Adds the states of a run for each amount, so that what is marked is what the run leaves, and
/// then what is beyond the strongest: a person who looks for what is too much has to see it.
void add_plain(const Problem& problem, StopWatch& watch, Growing& curve) {
  for (const Rung& rung : rungs_of_amounts(problem.metric())) {
    std::vector<Bounds> bounds = {rung.bounds};
    if (rung.amount == all_amounts().back().name)
      for (const double times : {2, 4})
        bounds.push_back(
            {times * rung.bounds.epsilon, times * *rung.bounds.local, times * *rung.bounds.detail});
    for (Bounds& each : bounds) each = problem.beyond_start(each);
    pass_plain(
        problem, bounds, watch, [&](const Candidate& written) { curve.add(written); },
        [&](std::size_t n) {
          if (n == 0) curve.mark(rung.amount);
        });
  }
}

/// Adds a state between any two amounts, too, as those of blocks are few. What is beyond the
/// strongest takes minutes, as the prices of all regions are needed that cost so much.
void add_blocks(const Problem& problem, StopWatch& watch, Growing& curve) {
  const Method& best = method_named(best_method);
  double last = 0;
  for (const auto& [bounds, amount] : rungs_of_amounts(problem.metric())) {
    for (const double epsilon : {(last + bounds.epsilon) / 2, bounds.epsilon}) {
      if (watch.is_over()) return;
      const Candidate written = best.run(
          problem.within(problem.beyond_start({epsilon, bounds.local, bounds.detail})), watch);
      if (written.changed && !watch.is_over()) curve.add(written);
    }
    curve.mark(amount);
    last = bounds.epsilon;
  }
}

}  // namespace

const char* name(MeshKind kind) { return kind == MeshKind::blocks ? "blocks" : "one gradient"; }

std::vector<MeshKind> curve_kinds(const Problem& problem) {
  std::vector<MeshKind> kinds;
  if (problem.gradient_rules && suits(method_named(plain_method), problem.mesh()))
    kinds.push_back(MeshKind::one_gradient);
  if (suits(method_named(best_method), problem.mesh())) kinds.push_back(MeshKind::blocks);
  return kinds;
}

StateCurve find_curve(const Problem& asked, MeshKind kind, StopWatch& watch,
                      const CurveGrown& grown) {
  const bool is_gradient = kind == MeshKind::one_gradient;
  const Method& method = method_named(is_gradient ? plain_method : best_method);
  if (const auto why = method.why_not(asked.mesh())) throw InputError(*why);
  Problem problem = is_gradient ? asked.as_gradient() : asked;
  problem.count = Count::handles;
  problem.bounds = {1};
  const ThreadLimit limit = problem.thread_limit();
  problem.trial();
  Growing curve(problem, grown);
  (is_gradient ? add_plain : add_blocks)(problem, watch, curve);
  return curve.take();
}

}  // namespace gradmesh
