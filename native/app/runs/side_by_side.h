#pragma once

#include <functional>
#include <mutex>
#include <vector>

#include "base/progress.h"
#include "base/waiting_caller.h"

namespace gradmesh {

/// Runs over the meshes of a document at the same time, of which the caller is told on the thread
/// that waits for them.
class SideBySide {
 public:
  /// `tell` may be empty. It is told of one mesh after another, of each until that has ended; until
  /// a mesh is begun, what `before` has of it.
  SideBySide(ProgressCallback tell, std::vector<Progress> before)
      : tell_(std::move(tell)), known_(std::move(before)), has_ended_(known_.size(), false) {}

  /// Returns what the run over a mesh tells. It returns false once the caller has cancelled.
  ProgressCallback progress_of(std::size_t mesh);
  /// The run over a mesh has ended.
  void end(std::size_t mesh);
  /// Has something called on the thread of run().
  void call_there(std::function<void()> what);

  /// Calls `work(job)` for each job in [0, jobs), lower ones first, at most `at_once` at the same
  /// time. Throws what `tell` throws, or else what `work` does.
  void run(std::size_t jobs, std::size_t at_once, const std::function<void(std::size_t)>& work);

 private:
  void change(const std::function<void()>& what);
  /// Returns true if the caller wants the runs to go on.
  bool tell_news();

  const ProgressCallback tell_;
  WaitingCaller caller_;
  /// The mesh that is told of, by the thread of run() alone.
  std::size_t told_ = 0;
  std::mutex mutex_;
  /// Guarded by the mutex: by mesh what is known of it, and what is to be called.
  std::vector<Progress> known_;
  std::vector<bool> has_ended_;
  std::vector<std::function<void()>> calls_;
};

}  // namespace gradmesh
