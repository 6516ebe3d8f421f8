#include "app/runs/curves.h"

#include <algorithm>
#include <stdexcept>

#include "base/error.h"

namespace gradmesh {
namespace {

MeshKind kind_for(const Problem& problem, const std::string& method) {
  const std::vector<MeshKind> kinds = curve_kinds(problem);
  if (method == simplest && !kinds.empty()) return kinds.front();
  return method == best_method ? MeshKind::blocks : MeshKind::one_gradient;
}

void check_has_curve(const RunOptions& options) {
  const auto& has = {std::string(simplest), std::string(plain_method), std::string(best_method)};
  if (std::ranges::find(has, options.method) == has.end())
    throw std::invalid_argument("a curve is of the methods simplest, plain and best.");
  if (options.has_target())
    throw std::invalid_argument("a curve has no target: it passes all numbers.");
}

const Method& method_of(MeshKind kind) {
  return method_named(kind == MeshKind::blocks ? best_method : plain_method);
}

}  // namespace

std::vector<MeshCurve> find_curves(const Document& document, const std::vector<std::string>& ids,
                                   const RunOptions& options, PriceFiles& files) {
  check_has_curve(options);
  std::vector<MeshCurve> curves;
  for (const MeshEntry& entry : document.selected(ids)) {
    const Problem problem = problem_of(document, entry, options, files);
    const MeshKind kind = kind_for(problem, options.method);
    StopWatch watch = watch_of(options);
    StateCurve curve = document.naming(entry, [&] { return find_curve(problem, kind, watch); });
    curve.states.front().objects = document.objects(entry);
    curves.push_back({entry, problem, kind, std::move(curve)});
  }
  return curves;
}

std::vector<MeshReport> write_states(Document& document, std::vector<TakenState> states,
                                     const WriteOptions& writing) {
  document.check_writing(writing);
  std::vector<MeshReport> reports;
  std::vector<ChangedMesh> changed;
  MetricKind metric = MetricKind::flip;
  for (auto& [entry, problem, kind, candidate] : states) {
    metric = problem.metric();
    SimplifyResult result = result_of(problem, method_of(kind), std::move(candidate));
    const MeshCounts before{result.handles_before, result.patches_before};
    if (result.changed) {
      changed.push_back({entry, result, before, problem.frame(), problem.original()->mesh()});
    } else {
      result.stopped = Stopped::nothing_to_merge;
      result.objects = document.objects(entry);
    }
    reports.push_back({entry.id, std::move(result)});
  }
  if (!changed.empty()) document.write(changed, metric, writing);
  return reports;
}

std::vector<MeshReport> write_states(Document& document, const std::vector<MeshCurve>& curves,
                                     int number, const WriteOptions& writing) {
  std::vector<TakenState> states;
  for (const auto& [entry, problem, kind, curve] : curves) {
    const int last = int(curve.states.size()) - 1;
    const CurveState& state = curve.states[std::size_t(std::clamp(number, 0, last))];
    const bool is_start = &state == &curve.states.front();
    const Problem written = kind == MeshKind::blocks ? problem : problem.as_gradient();
    states.push_back(
        {entry, problem, kind, is_start ? problem.unchanged() : written.measure(*state.mesh)});
  }
  return write_states(document, std::move(states), writing);
}

}  // namespace gradmesh
