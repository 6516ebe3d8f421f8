#pragma once

#include <algorithm>
#include <limits>
#include <vector>

namespace gradmesh {

/// The damping of Levenberg and Marquardt, a number for each unknown: it falls where a step helped,
/// and rises where it did harm.
class Damping {
 public:
  explicit Damping(std::size_t unknowns, double largest = std::numeric_limits<double>::infinity())
      : values_(unknowns, first), most_(largest) {}

  const std::vector<double>& values() const { return values_; }
  void lower(std::size_t unknown) {
    values_[unknown] = std::max(least, values_[unknown] / falls_by);
  }
  /// Raises it by less where `again` is true, after it was raised for the same step.
  void raise(std::size_t unknown, bool again = false) {
    values_[unknown] = std::min(most_, values_[unknown] * (again ? rises_again_by : rises_by));
  }
  /// Lets the unknown stay where it is.
  void hold(std::size_t unknown) { values_[unknown] = 1e12; }

 private:
  static constexpr double first = 1e-3, least = 1e-4;
  static constexpr double rises_by = 20, rises_again_by = 3, falls_by = 4;

  std::vector<double> values_;
  double most_;
};

/// What is made of a step that was tried.
struct Verdict {
  bool is_accepted = false;
  /// True if the step is worth another try without the unknowns that did harm.
  bool tries_again = false;
  /// By unknowns.
  std::vector<bool> did_harm = {};
};

/// Makes one step of Levenberg and Marquardt on a surface that unknowns move: all of the step at
/// first, and then without what did harm, in at most `attempts` attempts. Returns true if the step
/// was accepted; otherwise the surface is as it was.
///
/// A Surface has `unknown_count()`; `step()`, by how much to move each unknown; `move(step, held)`,
/// which moves all unknowns but those held; `judge(attempt)`, which returns the Verdict on the
/// moved surface and adapts the damping; and `take_back()`, which undoes the last move.
template <class Surface>
bool refit(Surface& surface, int attempts) {
  const auto step = surface.step();
  std::vector<bool> held(surface.unknown_count(), false);
  for (int attempt = 0; attempt < attempts; ++attempt) {
    surface.move(step, held);
    const Verdict verdict = surface.judge(attempt);
    if (verdict.is_accepted) return true;
    surface.take_back();
    if (!verdict.tries_again) return false;
    for (std::size_t u = 0; u < held.size(); ++u) held[u] = held[u] || verdict.did_harm[u];
  }
  return false;
}

}  // namespace gradmesh
