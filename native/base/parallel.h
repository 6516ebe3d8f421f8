#pragma once

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <thread>

namespace gradmesh {

/// Calls `body(i)` for every i in [0, count), on as many threads as the innermost ThreadLimit
/// allows; once one has thrown, some of the others are not called. Bodies must not depend on each
/// other, and may call parallel_for themselves: a thread that waits for the others takes no body of
/// another loop meanwhile, so that what it keeps for itself (base/per_thread.h) stays as it was. A
/// caller that sums over i does so afterwards, in order, so that results do not depend on the
/// number of threads.
template <class Body>
void parallel_for(std::size_t count, const Body& body) {
#ifdef __SANITIZE_THREAD__
  // Debian's oneTBB is not built for the thread sanitizer, which would not see it synchronise.
  std::atomic<std::size_t> next{0};
  std::exception_ptr faults[2];
  const auto work = [&](std::exception_ptr& fault) {
    try {
      for (std::size_t i; (i = next++) < count;) body(i);
    } catch (...) {
      fault = std::current_exception();
      next = count;
    }
  };
  std::jthread other([&] { work(faults[1]); });
  work(faults[0]);
  other.join();
  for (const std::exception_ptr& fault : faults)
    if (fault) std::rethrow_exception(fault);
#else
  // Of a loop within one of which a body has thrown, oneTBB leaves out the rest without a word,
  // unless it is in a context of its own.
  tbb::task_group_context context(tbb::task_group_context::isolated);
  tbb::this_task_arena::isolate([&] {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, count),
        [&](const tbb::blocked_range<std::size_t>& range) {
          for (std::size_t i = range.begin(); i != range.end(); ++i) body(i);
        },
        context);
  });
#endif
}

/// Calls `body(worker, i)` for each i in [0, count), lower ones first, on as many threads as there
/// are workers; `worker` is a number below `workers` of which there are not two calls at the same
/// time.
template <class Body>
void parallel_in_turn(std::size_t workers, std::size_t count, const Body& body) {
  std::atomic<std::size_t> next = 0;
  parallel_for(std::min(workers, count), [&](std::size_t worker) {
    for (std::size_t i; (i = next++) < count;) body(worker, i);
  });
}

/// Returns the largest number of threads on which parallel_for works now.
inline std::size_t thread_count() {
#ifdef __SANITIZE_THREAD__
  return 2;
#else
  const auto allowed =
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  return std::clamp(std::size_t(tbb::this_task_arena::max_concurrency()), std::size_t(1), allowed);
#endif
}

/// As long as it lives, parallel_for uses at most `threads` threads (0: all cores).
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads)
      : control_(tbb::global_control::max_allowed_parallelism,
                 threads > 0 ? std::size_t(threads)
                             : tbb::global_control::active_value(
                                   tbb::global_control::max_allowed_parallelism)) {}

 private:
  tbb::global_control control_;
};

}  // namespace gradmesh
