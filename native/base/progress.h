#pragma once

#include <chrono>
#include <functional>

namespace gradmesh {

/// How far a long run has come.
struct Progress {
  std::size_t done = 0, total = 0;
  int patches = 0;
  double error = 0;
  /// 0 where patches are what a run makes fewer.
  int handles = 0;
  /// Which of several meshes is at work, from 0, and how many they are.
  std::size_t mesh = 0, meshes = 1;
};

/// Called from the thread that started the run; returning false cancels it.
using ProgressCallback = std::function<bool(const Progress&)>;

/// Tells when a run has to stop, and why.
class StopWatch {
 public:
  enum class Reason { none, budget, cancelled };

  /// `budget` is in seconds, counted from now; 0 or less means no limit.
  StopWatch(double budget, ProgressCallback callback)
      : start_(Clock::now()), budget_(budget), callback_(std::move(callback)) {}

  /// Reports progress. Returns true if the run has to stop, now and ever after.
  bool should_stop(const Progress& progress) {
    if (reason_ == Reason::none && callback_ && !callback_(progress)) reason_ = Reason::cancelled;
    if (reason_ == Reason::none && budget_ > 0 && seconds() > budget_) reason_ = Reason::budget;
    return reason_ != Reason::none;
  }
  Reason reason() const { return reason_; }
  /// Returns true if the run has to stop, or has no time left to begin something else.
  bool is_over() const { return reason_ != Reason::none || (budget_ > 0 && seconds() >= budget_); }
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_;
  double budget_;
  ProgressCallback callback_;
  Reason reason_ = Reason::none;
};

}  // namespace gradmesh
