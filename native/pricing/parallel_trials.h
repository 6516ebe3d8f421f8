#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

#include "base/parallel.h"

namespace gradmesh {

/// Calls `body(worker, i)` as parallel_in_turn does. `stop(done)`, `done` being the number of calls
/// that have ended, is called on the calling thread, before anything is begun and before each of
/// that thread's calls of the body; once it returns true no more calls are begun. Returns true if
/// `stop` never returned true.
template <class Body>
bool for_each_in_turn(std::size_t workers, std::size_t count,
                      const std::function<bool(std::size_t done)>& stop, const Body& body) {
  // Now, as others may be done before it gets to its first call.
  if (stop(0)) return false;
  const std::thread::id caller = std::this_thread::get_id();
  std::atomic<std::size_t> done = 0;
  std::atomic<bool> stopped = false;
  parallel_in_turn(workers, count, [&](std::size_t worker, std::size_t i) {
    if (!stopped && std::this_thread::get_id() == caller && stop(done)) stopped = true;
    if (stopped) return;
    body(worker, i);
    ++done;
  });
  return !stopped;
}

/// Runs many independent trials on all cores: each thread has a trial of its own, with its own
/// mesh, journal and window, and all start from the same state. Trial is a MergeTrial or another
/// type that can be forked.
template <class Trial>
class ParallelTrials {
 public:
  /// `trial` must be as it was at first at every call of for_each.
  explicit ParallelTrials(Trial& trial) : trials_{&trial} {
    while (trials_.size() < thread_count()) {
      forks_.push_back(trial.fork());
      trials_.push_back(&forks_.back()->trial);
    }
  }

  /// Calls `body(trial, i)` for each i in [0, count), as for_each_in_turn does; the body must leave
  /// its trial as it found it.
  template <class Body>
  bool for_each(std::size_t count, const std::function<bool(std::size_t done)>& stop,
                const Body& body) {
    return for_each_in_turn(trials_.size(), count, stop,
                            [&](std::size_t own, std::size_t i) { body(*trials_[own], i); });
  }

 private:
  std::vector<std::unique_ptr<typename Trial::Fork>> forks_;
  std::vector<Trial*> trials_;
};

}  // namespace gradmesh
