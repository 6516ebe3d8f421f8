#include "window/view/chart.h"

#include <algorithm>
#include <cmath>

namespace gradmesh {

Chart::Chart(const std::vector<CurveState>& states, ImVec2 low, ImVec2 high, bool by_patches)
    : states_(states), low_(low), high_(high), by_patches_(by_patches) {
  most_ = std::max(size(states.front().counts), 1);
  least_ = std::min(size(states.back().counts), most_ - 1);
  for (const CurveState& state : states) highest_ = std::max(highest_, state.error);
  if (highest_ == 0) highest_ = 1;
}

ImVec2 Chart::place(const MeshCounts& counts, double error) const {
  const double along = std::clamp(double(most_ - size(counts)) / (most_ - least_), 0.0, 1.0);
  // By the root, as what is hardly seen is what is looked for.
  const double above = std::sqrt(std::clamp(error / highest_, 0.0, 1.0));
  return {low_.x + float(along) * (high_.x - low_.x), high_.y - float(above) * (high_.y - low_.y)};
}

int Chart::state_at(float x) const {
  const auto closest = std::ranges::min_element(
      states_, {}, [&](const CurveState& state) { return std::abs(place(state).x - x); });
  return int(closest - states_.begin());
}

}  // namespace gradmesh
