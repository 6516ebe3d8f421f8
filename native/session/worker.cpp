#include "session/worker.h"

#include <utility>

namespace gradmesh {

Worker::~Worker() {
  end();
  wait();
}

void Worker::add(Task task) {
  const std::lock_guard lock(mutex_);
  tasks_.push_back(std::move(task));
  if (is_running_) return;
  if (thread_.joinable()) thread_.join();
  is_running_ = true;
  thread_ = std::thread([this] { run(); });
}

void Worker::wait() {
  if (thread_.joinable()) thread_.join();
}

bool Worker::is_busy() const {
  const std::lock_guard lock(mutex_);
  return is_running_;
}

void Worker::run() {
  for (;;) {
    Task task;
    {
      const std::lock_guard lock(mutex_);
      if (tasks_.empty() || must_end_) {
        is_running_ = false;
        return;
      }
      task = std::move(tasks_.front());
      tasks_.erase(tasks_.begin());
    }
    task(must_end_);
  }
}

}  // namespace gradmesh
