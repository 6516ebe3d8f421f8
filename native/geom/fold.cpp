#include "geom/fold.h"

#include <algorithm>
#include <cmath>

#include "geom/cross.h"

namespace gradmesh {

bool folds(const Patch& patch) {
  constexpr int steps = 16;
  constexpr double rounding = 1e-3;
  double least = 0, most = 0;
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; j <= steps; ++j) {
      const double u = double(i) / steps, v = double(j) / steps;
      const double area =
          cross(patch.derivative_u(u, v).position, patch.derivative_v(u, v).position);
      least = std::min(least, area);
      most = std::max(most, area);
    }
  return std::min(-least, most) > rounding * std::max(-least, most);
}

Outline covered_cells(const Patch& patch) {
  constexpr int steps = 16;
  const auto at = [&](int i, int j) {
    return patch.at(double(i) / steps, double(j) / steps).position;
  };
  Outline cells;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j) {
      std::vector<glm::dvec2> cell{at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)};
      if (cross(cell[2] - cell[0], cell[3] - cell[1]) < 0) std::ranges::reverse(cell);
      cells.push_back(std::move(cell));
    }
  return cells;
}

}  // namespace gradmesh
