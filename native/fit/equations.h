#pragma once

#include <Eigen/Core>
#include <vector>

#include "fit/target.h"
#include "fit/unknowns.h"

namespace gradmesh {

/// Where the numbers of each unknown stand in the equations: x and y from `place` on, in pixels,
/// and r, g, b from `color` on, -1 where colour does not count.
struct Columns {
  std::vector<int> place, color;
  int count = 0;

  explicit Columns(const std::vector<Unknown>& unknowns);
};

/// Normal equations of least squares over some of the columns: matrix * step = rhs.
struct NormalEquations {
  std::vector<int> columns;
  Eigen::MatrixXd matrix;
  Eigen::VectorXd rhs;
};

/// How the picture of a face and the target's differ, to first order in the unknowns: by colour at
/// samples over the patch, each as large as the area it stands for, and where its sides are
/// outlines by how far these are from the target's. At a fixed place of the picture the colour
/// changes with the patch's colours, and with its places as much as colour changes along the way
/// there: so the gradients of the patch's own colours are all that is needed, and places can do
/// what colours cannot.
NormalEquations normal_equations(const Mesh& mesh, const InfluencedFace& face,
                                 const Columns& columns, const FitTarget& target);

/// Solves the sum of them. `damping` by column: the diagonal is raised by this share of itself
/// (Levenberg and Marquardt). Not finite where that fails.
Eigen::VectorXd solve(const std::vector<NormalEquations>& parts, const Eigen::VectorXd& damping);

}  // namespace gradmesh
