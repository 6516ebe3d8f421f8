#include "app/runs/mesh_runs.h"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <utility>

#include "app/document/originals.h"
#include "base/limits.h"
#include "simplify/tries.h"

namespace gradmesh {
namespace {

/// Throws InputError if the error of a mesh was above epsilon before anything was merged, because
/// of another colour model or another document.
void check_start(const Document& document, const MeshEntry& entry, const SimplifyResult& result,
                 const RunOptions& options, double epsilon) {
  if (options.has_target() || result.changed || result.error <= epsilon) return;
  // Earlier runs with a larger epsilon may have moved the mesh away from the original.
  if (may_differ(document, entry) && !options.original) return;
  char error[32];
  std::snprintf(error, sizeof error, "%.5f", result.error);
  throw InputError(
      "{0}: before anything is merged, its error in the color model {1} is {2}, above epsilon.",
      document.describe(entry), name(result.mesh.color_model()), error);
}

/// Returns what tells of one of several meshes; empty if nothing is told.
ProgressCallback progress_of(const ProgressCallback& tell, std::size_t mesh, std::size_t meshes) {
  if (!tell) return {};
  return [=](Progress now) {
    now.mesh = mesh;
    now.meshes = meshes;
    return tell(now);
  };
}

}  // namespace

/// Simplifies meshes of a document, each one once: drawings are full of copies, and one that lies,
/// is seen and will be written like another becomes what that has become.
class MeshRuns::SharedRuns {
 public:
  explicit SharedRuns(const RunOptions& options) : options_(options) {}

  /// `key` is that of the problem's prices.
  SimplifyResult result_of(const Problem& problem, const PriceTableKey& key, StopWatch& watch) {
    for (const Run& run : runs_)
      if (run.key == key && are_like(run.rules, problem.rules) &&
          are_like(run.gradient_rules, problem.gradient_rules))
        return as_copy(run.result);
    SimplifyResult result = simplify_as_asked(problem, options_.method, watch);
    if (!watch.is_over()) runs_.push_back({key, problem.rules, problem.gradient_rules, result});
    return result;
  }

 private:
  using Rules = std::shared_ptr<const WritingRules>;

  struct Run {
    PriceTableKey key;
    Rules rules, gradient_rules;
    SimplifyResult result;
  };

  static bool are_like(const Rules& a, const Rules& b) {
    return a == b || (a && b && a->are_like(*b));
  }

  static SimplifyResult as_copy(SimplifyResult result) {
    result.evaluations = 0;
    result.seconds = {};
    return result;
  }

  const RunOptions& options_;
  std::vector<Run> runs_;
};

std::vector<MeshRun> MeshRuns::run() && {
  const ThreadLimit limit(options_.threads);
  const std::vector<Job> jobs = jobs_by_size();
  const std::size_t at_once = most_at_once(jobs);
  at_once > 1 ? run_side_by_side(jobs, at_once) : run_in_turn();
  return std::move(runs_);
}

MergeTrial::DeviceLost MeshRuns::telling_device_lost() {
  if (!options_.device_lost) return {};
  return [this](const DeviceError& error) {
    const auto tell = [tell = options_.device_lost, error] { tell(error); };
    side_by_side_ ? side_by_side_->call_there(tell) : tell();
  };
}

std::vector<MeshRuns::Job> MeshRuns::jobs_by_size() const {
  std::vector<Job> jobs;
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    const auto same = std::ranges::find_if(
        jobs, [&](const Job& job) { return runs_[job.front()].key == runs_[i].key; });
    if (same != jobs.end())
      same->push_back(i);
    else
      jobs.push_back({i});
  }
  std::ranges::stable_sort(jobs, std::greater{}, [&](const Job& job) {
    return runs_[job.front()].problem->mesh().face_count();
  });
  return jobs;
}

std::size_t MeshRuns::most_at_once(const std::vector<Job>& jobs) const {
  // A run has a trial for each thread, whoever else is at work.
  std::vector<std::uint64_t> bytes;
  for (const Job& job : jobs)
    bytes.push_back(measuring_bytes(runs_[job.front()].frame, thread_count()));
  std::ranges::sort(bytes, std::greater{});
  const std::size_t most = std::min(thread_count(), jobs.size());
  std::uint64_t sum = 0;
  std::size_t fit = 0;
  while (fit < most && (sum += bytes[fit]) <= limits().memory) ++fit;
  return fit;
}

void MeshRuns::run_in_turn() {
  SharedRuns shared(options_);
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    run(i, shared, progress_of(options_.progress, i, runs_.size()));
    if (runs_[i].fault) std::rethrow_exception(runs_[i].fault);
  }
}

void MeshRuns::run_side_by_side(const std::vector<Job>& jobs, std::size_t at_once) {
  std::vector<Progress> before;
  for (std::size_t i = 0; i < runs_.size(); ++i)
    before.push_back({0, 1, runs_[i].problem->mesh().face_count(), 0, 0, i, runs_.size()});
  side_by_side_.emplace(options_.progress, std::move(before));
  side_by_side_->run(jobs.size(), at_once, [&](std::size_t job) {
    SharedRuns shared(options_);
    for (const std::size_t i : jobs[job]) {
      run(i, shared, side_by_side_->progress_of(i));
      side_by_side_->end(i);
    }
  });
  for (const MeshRun& run : runs_)
    if (run.fault) std::rethrow_exception(run.fault);
}

void MeshRuns::run(std::size_t mesh, SharedRuns& shared, ProgressCallback progress) {
  MeshRun& run = runs_[mesh];
  try {
    StopWatch watch(options_.time_budget, std::move(progress));
    run.result =
        document_.naming(run.entry, [&] { return shared.result_of(*run.problem, run.key, watch); });
    check_start(document_, run.entry, *run.result, options_, run.problem->bounds.epsilon);
  } catch (...) {
    run.fault = std::current_exception();
  }
  run.problem.reset();
}

}  // namespace gradmesh
