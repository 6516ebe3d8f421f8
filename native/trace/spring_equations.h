#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <utility>
#include <vector>

#include "trace/equations.h"

namespace gradmesh {

/// The equations of some points of a grid that springs pull at: the sum of the squares of residuals
/// that depend on where these points are, to first order.
class SpringEquations {
 public:
  SpringEquations(const LineGrid& grid, const TargetPicture& target, const GridColumns& columns,
                  std::span<const int> points);

  /// Adds `weight` times the square of a residual. `by` is how this changes with the place of each
  /// point in pixels, in the order of the constructor's points.
  void add(double weight, double residual, std::span<const glm::dvec2> by);

  const NormalEquations& sum() const { return sum_; }

 private:
  NormalEquations sum_;
  /// For each column of the equations, which of the points it moves, and along which way.
  std::vector<std::pair<std::size_t, glm::dvec2>> ways_;
};

}  // namespace gradmesh
