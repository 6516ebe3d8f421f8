#include "base/waiting_caller.h"

#include <exception>
#include <thread>

namespace gradmesh {

void WaitingCaller::wait_for(const std::function<void()>& work, const std::function<bool()>& tell) {
  std::exception_ptr by_work, by_tell;
  has_ended_ = false;
  std::jthread worker([&] {
    try {
      work();
    } catch (...) {
      by_work = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    has_ended_ = true;
    changed_.notify_one();
  });
  for (bool goes_on = true; goes_on;) {
    {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [&] { return is_news_ || has_ended_; });
      goes_on = !has_ended_;
      if (!is_news_) break;
      is_news_ = false;
    }
    try {
      if (!should_end_ && !tell()) should_end_ = true;
    } catch (...) {
      by_tell = std::current_exception();
      should_end_ = true;
    }
  }
  worker.join();
  if (by_tell) std::rethrow_exception(by_tell);
  if (by_work) std::rethrow_exception(by_work);
}

void WaitingCaller::there_is_news() {
  const std::lock_guard lock(mutex_);
  is_news_ = true;
  changed_.notify_one();
}

}  // namespace gradmesh
