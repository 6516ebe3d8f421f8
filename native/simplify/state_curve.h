#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/progress.h"
#include "form/counts.h"
#include "problem/problem.h"

namespace gradmesh {

/// A mesh between the one that a person has and the simplest that is worth seeing, measured as it
/// will be written.
struct CurveState {
  std::shared_ptr<const Mesh> mesh;
  MeshCounts counts;
  /// The number of objects that paint it.
  int objects = 1;
  /// As of Candidate.
  double error = 0, local_error = 0;
};

/// What a mesh is in its document, and so all states of a curve.
enum class MeshKind { one_gradient, blocks };

/// Returns the name in files, such as "one gradient".
const char* name(MeshKind kind);

/// The states that simplifying passes, from the mesh as it is on, each with fewer handles than the
/// one before.
struct StateCurve {
  /// What a run with an amount (all_amounts) leaves.
  struct Mark {
    std::string amount;
    int state;
  };

  std::vector<CurveState> states;
  std::vector<Mark> marks;
};

/// Called when a curve has changed at its end: a state was added, or the last one has become
/// another.
using CurveGrown = std::function<void(const StateCurve&)>;

/// Returns the curve of a problem, whose own bounds do not count. It ends beyond the strongest
/// amount, or earlier if the watch says so. A curve of one gradient has each step of `plain` as a
/// state that leaves fewer handles than those before, of a run for each amount; one of blocks has
/// what `best` makes of a row of errors. Throws InputError if the mesh covers no pixel, and for
/// blocks if `best` cannot work on it.
StateCurve find_curve(const Problem& problem, MeshKind kind, StopWatch& watch,
                      const CurveGrown& grown = {});

/// Returns the kinds of curves that a problem has: one gradient only where the mesh is one and may
/// stay one, blocks only where `best` can work on it.
std::vector<MeshKind> curve_kinds(const Problem& problem);

}  // namespace gradmesh
