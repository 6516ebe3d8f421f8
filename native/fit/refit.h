#pragma once

#include <vector>

namespace gradmesh {

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
