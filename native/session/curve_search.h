#pragma once

#include <map>
#include <mutex>
#include <optional>

#include "base/message.h"
#include "session/worker.h"
#include "simplify/state_curve.h"

namespace gradmesh {

/// Finds curves of a problem while other things go on. All members may be called at any time from
/// one thread.
class CurveSearch {
 public:
  /// What is found of a curve until now.
  struct Found {
    StateCurve curve;
    bool is_complete = false;
    /// Why the search has ended early.
    std::optional<Message> failure;
  };

  explicit CurveSearch(const Problem& problem) : problem_(problem) {}

  /// Sees to it that a curve is searched for, after those that are being searched for.
  void request(MeshKind kind);
  /// Waits until all curves that are wanted are complete.
  void wait() { worker_.wait(); }
  /// Ends the search, which is busy until it has ended.
  void end() { worker_.end(); }
  bool is_busy() const { return worker_.is_busy(); }

  /// Returns what is found of a curve, from a state on; nothing if it is not wanted.
  std::optional<Found> found(MeshKind kind) const;

 private:
  void search(MeshKind kind, const std::atomic<bool>& must_end);

  const Problem problem_;
  mutable std::mutex mutex_;
  std::map<MeshKind, Found> curves_;
  /// Destroyed first, so that no task outlives what it writes to.
  Worker worker_;
};

/// Runs `search`. Returns why it has failed; nothing if it has not.
std::optional<Message> failure_of(const std::function<void()>& search);

}  // namespace gradmesh
