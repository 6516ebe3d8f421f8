#include "geom/nearest.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace gradmesh {

double nearest(const Cubic<glm::dvec2>& curve, glm::dvec2 point, double low, double high) {
  const auto distance = [&](double t) { return glm::distance(curve.at(t), point); };
  constexpr int samples = 64;
  const double step = (high - low) / samples;
  int best = 0;
  for (int i = 1; i <= samples; ++i)
    if (distance(low + i * step) < distance(low + best * step)) best = i;
  // Around the best sample there is one minimum: its bracket is narrowed by thirds.
  double a = low + std::max(best - 1, 0) * step, b = low + std::min(best + 1, samples) * step;
  for (int i = 0; i < 60; ++i) {
    const double third = (b - a) / 3;
    if (distance(a + third) <= distance(b - third))
      b -= third;
    else
      a += third;
  }
  return 0.5 * (a + b);
}

}  // namespace gradmesh
