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

/// Measures the whole frame, of the mesh as it will be written, into `result`; whether that keeps
/// to epsilon.
bool measure(const Mesh& mesh, const EditError& error, const SimplifyOptions& options,
             SimplifyResult& result) {
  std::vector<Mesh> ways;
  if (options.ways_to_write) ways = options.ways_to_write(mesh, result.frame);
  if (ways.empty()) ways.push_back(mesh);
  for (result.way = 0; result.way < int(ways.size()); ++result.way) {
    result.error = error.whole_frame(ways[result.way]);
    if (result.error <= options.epsilon) return true;
  }
  return false;
}

/// Blocks are painted in another order than faces, which shows where a mesh lies over itself.
/// Should the error as written be above epsilon, the last merges are taken back, ever more at a
/// time.
void verify(Journal& journal, const EditError& error, const SimplifyOptions& options,
            SimplifyResult& result) {
  for (int at_once = 1; journal.depth() > 0; at_once *= 2) {
    if (measure(journal.mesh(), error, options, result)) return;
    for (int i = 0; i < at_once && journal.depth() > 0; ++i) journal.undo();
  }
  result.error = 0;
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

  verify(journal, error, options, result);
  result.patches_after = mesh.face_count();
  result.stopped = why_stopped(watch, result);
  result.seconds.total = watch.seconds();
  result.seconds.verify = result.seconds.total - result.seconds.rasterize - result.seconds.select;
  return result;
}

}  // namespace gradmesh
