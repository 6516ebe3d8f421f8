#pragma once

#include <imgui.h>

#include "simplify/state_curve.h"

namespace gradmesh {

/// Where the states of a curve are in a rectangle: from many handles to few, left to right, by the
/// error, below to above.
class Chart {
 public:
  /// `by_patches` has patches in the place of handles.
  Chart(const std::vector<CurveState>& states, ImVec2 low, ImVec2 high, bool by_patches);

  ImVec2 place(const MeshCounts& counts, double error) const;
  ImVec2 place(const CurveState& state) const { return place(state.counts, state.error); }
  /// Returns the state that is closest to a place from left to right.
  int state_at(float x) const;

 private:
  int size(const MeshCounts& counts) const { return by_patches_ ? counts.patches : counts.handles; }

  const std::vector<CurveState>& states_;
  const ImVec2 low_, high_;
  const bool by_patches_;
  int most_, least_;
  double highest_ = 0;
};

}  // namespace gradmesh
