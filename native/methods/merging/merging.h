#pragma once

#include <functional>

#include "problem/problem.h"

namespace gradmesh {

/// Merges in a trial as long as its epsilon and the local bound allow it. The prices are of the
/// mesh of the trial as it is now, and may be added to.
using Merge = std::function<void(MergeTrial& trial, PriceTable& prices)>;

/// What is special about how a method merges.
struct MergingRules {
  /// True if merges are taken back until the mesh is a rectangle of patches again.
  bool keeps_rectangle = false;
  /// True if merging goes on after merges were taken back.
  bool merges_again = true;
};

/// Merges until nothing more fits. The error as written may be larger than that of the merges,
/// since blocks are painted in another order than faces, which shows where a mesh lies over itself.
/// Then takes the last merges back, lowers epsilon by what writing adds, and merges what still
/// fits. Returns the mesh that is then in the trial.
Candidate merge_what_fits(const Problem& problem, MergeTrial& trial, const Merge& merge,
                          MergingRules rules = {});

}  // namespace gradmesh
