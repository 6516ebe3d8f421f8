#include "simplify/simplify.h"

#include <cmath>
#include <stdexcept>

#include "base/parallel.h"
#include "error/merge_trial.h"
#include "select/grid.h"

namespace gradmesh {
namespace {

void check(const SimplifyOptions& options) {
  if (!(options.epsilon >= 0 && options.epsilon <= 1))
    throw std::invalid_argument("epsilon must be between 0 and 1.");
  if (options.resolution < 16 || options.resolution > 8192)
    throw std::invalid_argument("the resolution must be between 16 and 8192 pixels.");
  if (!std::isfinite(options.time_budget) || options.time_budget < 0)
    throw std::invalid_argument("the time budget must be 0 or more seconds.");
  if (options.threads < 0) throw std::invalid_argument("threads must be 0 or more.");
}

void select(const SimplifyOptions& options, MergeTrial& trial, StopWatch& watch) {
  switch (options.method) {
    case Method::grid:
      return select_grid(trial, options.seed, watch);
  }
}

/// The whole frame's error. Windows add up to it but for rounding; should that ever lie on the
/// wrong side of epsilon, the last merges are taken back.
double verify(Journal& journal, const EditError& error, double epsilon) {
  double measured = error.whole_frame(journal.mesh());
  while (measured > epsilon && journal.depth() > 0) {
    journal.undo();
    measured = error.whole_frame(journal.mesh());
  }
  return measured;
}

Stopped why_stopped(const StopWatch& watch, const SimplifyResult& result) {
  if (watch.reason() == StopWatch::Reason::cancelled) return Stopped::cancelled;
  if (watch.reason() == StopWatch::Reason::budget) return Stopped::budget;
  return result.patches_after == result.patches_before ? Stopped::nothing_to_merge : Stopped::done;
}

}  // namespace

SimplifyResult simplify(Mesh& mesh, const SimplifyOptions& options) {
  check(options);
  const ThreadLimit limit(options.threads);
  StopWatch watch(options.time_budget, options.progress);
  SimplifyResult result;
  result.patches_before = mesh.face_count();
  result.frame = fit_frame(mesh, options.view, options.resolution);

  EditError error(mesh, result.frame, options.metric);
  result.seconds.rasterize = watch.seconds();

  Journal journal(mesh);
  MergeTrial trial(journal, error, options.epsilon);
  select(options, trial, watch);
  result.evaluations = trial.evaluations();
  result.seconds.select = watch.seconds() - result.seconds.rasterize;

  result.error = verify(journal, error, options.epsilon);
  result.patches_after = mesh.face_count();
  result.stopped = why_stopped(watch, result);
  result.seconds.total = watch.seconds();
  result.seconds.verify = result.seconds.total - result.seconds.rasterize - result.seconds.select;
  return result;
}

}  // namespace gradmesh
