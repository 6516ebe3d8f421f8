#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace gradmesh {

/// Does tasks one after another while other things go on. All members may be called at any time
/// from one thread.
class Worker {
 public:
  /// A task ends early once `must_end` is true. It throws nothing.
  using Task = std::function<void(const std::atomic<bool>& must_end)>;

  Worker() = default;
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;
  /// Ends all tasks.
  ~Worker();

  /// Adds a task after those that are there.
  void add(Task task);
  /// Waits until all tasks are done.
  void wait();
  /// Lets the task that goes on end, and begins no other.
  void end() { must_end_ = true; }
  /// Returns true as long as a task goes on or waits for its turn.
  bool is_busy() const;

 private:
  void run();

  mutable std::mutex mutex_;
  std::vector<Task> tasks_;
  std::atomic<bool> must_end_ = false;
  bool is_running_ = false;
  std::thread thread_;
};

}  // namespace gradmesh
