#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>

namespace gradmesh {

/// Has work done on other threads, while the thread that asked for it waits and tells how far it
/// is: whoever is told expects to be called there.
class WaitingCaller {
 public:
  /// Runs `work` on a thread of its own, and returns when it has ended. Calls `tell` on the calling
  /// thread whenever there is news, until it returns false or throws; then should_end() is true.
  /// Throws what `tell` has thrown, or else what `work` has.
  void wait_for(const std::function<void()>& work, const std::function<bool()>& tell);

  /// Says that there is news, on any thread.
  void there_is_news();
  /// Returns true if the work is wanted no longer.
  bool should_end() const { return should_end_; }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool is_news_ = false, has_ended_ = false;
  std::atomic<bool> should_end_ = false;
};

}  // namespace gradmesh
