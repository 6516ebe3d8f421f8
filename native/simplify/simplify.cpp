#include "simplify/simplify.h"

#include <algorithm>
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

/// The smallest error of the mesh as it can be written; the first that keeps to epsilon will do.
double error_as_written(const Mesh& mesh, const EditError& error, const SimplifyOptions& options,
                        const Frame& frame) {
  if (!options.ways_to_write) return error.whole_frame(mesh);
  double best = 1;
  for (const Mesh& written : options.ways_to_write(mesh, frame)) {
    best = std::min(best, error.whole_frame(written));
    if (best <= options.epsilon) break;
  }
  return best;
}

/// Measures the whole frame, of the mesh as it will be written. Its blocks are painted in another
/// order than its faces, which may show where patches touch; should the error lie above epsilon,
/// the last merges are taken back, ever more at a time, since each measurement takes a while.
double verify(Journal& journal, const EditError& error, const SimplifyOptions& options,
              const Frame& frame) {
  for (int at_once = 1;; at_once *= 2) {
    const double measured = error_as_written(journal.mesh(), error, options, frame);
    if (measured <= options.epsilon || journal.depth() == 0) return measured;
    for (int i = 0; i < at_once && journal.depth() > 0; ++i) journal.undo();
  }
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

  result.error = verify(journal, error, options, result.frame);
  result.patches_after = mesh.face_count();
  result.stopped = why_stopped(watch, result);
  result.seconds.total = watch.seconds();
  result.seconds.verify = result.seconds.total - result.seconds.rasterize - result.seconds.select;
  return result;
}

}  // namespace gradmesh
