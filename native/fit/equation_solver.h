#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "fit/elimination.h"
#include "fit/equations.h"

namespace gradmesh {

/// Solves sums of equations over the same columns again and again, as a fit needs them. What
/// depends on the columns alone is found the first time.
class EquationSolver {
 public:
  /// Does what solve() does, on all threads. All calls must have parts with the same columns, in
  /// the same order, and as many columns in all. May be called concurrently after prepare().
  Eigen::VectorXd solve(const std::vector<NormalEquations>& parts, const Eigen::VectorXd& damping);
  /// Finds what depends on the columns of the parts alone, unless it is found.
  void prepare(const std::vector<NormalEquations>& parts, Eigen::Index columns);

 private:
  /// Fronts of disjoint trees, which may be eliminated at the same time, and those after all of
  /// these.
  struct Order {
    Elimination elimination;
    std::vector<std::vector<int>> trees;
    std::vector<int> afterwards;

    Order(const std::vector<NormalEquations>& parts, Eigen::Index columns);
  };

  std::optional<Order> order_;
};

}  // namespace gradmesh
