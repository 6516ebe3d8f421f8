#pragma once

#include <cstddef>
#include <exception>
#include <memory>
#include <optional>
#include <vector>

#include "app/document/document.h"
#include "app/runs/side_by_side.h"
#include "simplify/simplify.h"

namespace gradmesh {

/// The run over one mesh of a document.
struct MeshRun {
  MeshEntry entry;
  PriceTableKey key;
  /// Nothing once it is over: its picture is needed no longer.
  std::optional<Problem> problem;
  Frame frame;
  std::shared_ptr<const Mesh> original;
  /// What it came to, or why to nothing.
  std::optional<SimplifyResult> result = std::nullopt;
  std::exception_ptr fault = nullptr;

  MeshRun(MeshEntry of, Problem made)
      : entry(std::move(of)),
        key(made.price_key()),
        problem(std::move(made)),
        frame(problem->frame()),
        original(problem->original()->mesh()) {}
};

/// Works on the meshes of a document, on several at the same time where there are threads and
/// memory for that.
class MeshRuns {
 public:
  MeshRuns(const Document& document, const RunOptions& options)
      : document_(document), options_(options) {}

  void add(MeshEntry entry, Problem problem) {
    runs_.emplace_back(std::move(entry), std::move(problem));
  }

  /// Returns the runs. Throws what the first of them has thrown that has no result.
  std::vector<MeshRun> run() &&;

  /// Has what the run over a mesh has to say about a lost device told on the caller's thread.
  MergeTrial::DeviceLost telling_device_lost();

 private:
  class SharedRuns;
  /// Numbers of meshes that have their prices in common, so that each is begun after the one before
  /// has ended.
  using Job = std::vector<std::size_t>;

  /// Returns the jobs, the one with the largest mesh first.
  std::vector<Job> jobs_by_size() const;

  /// Returns how many jobs may be at work at the same time.
  std::size_t most_at_once(const std::vector<Job>& jobs) const;
  void run_in_turn();
  void run_side_by_side(const std::vector<Job>& jobs, std::size_t at_once);
  /// Works on one mesh. Throws nothing.
  void run(std::size_t mesh, SharedRuns& shared, ProgressCallback progress);

  const Document& document_;
  const RunOptions& options_;
  std::vector<MeshRun> runs_;
  std::optional<SideBySide> side_by_side_;
};

}  // namespace gradmesh
