#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "fit/unknowns.h"
#include "reference/reference.h"

namespace gradmesh {

/// The columns of the equations for each unknown: `place` and the next one for x and y, in pixels;
/// `color` and the next two for r, g, b, or -1 where colour does not count.
struct Columns {
  std::vector<int> place, color;
  int count = 0;

  explicit Columns(const std::vector<Unknown>& unknowns);
  /// Columns of that many unknowns that are places alone.
  explicit Columns(int places);
};

/// How differences of colour count: as their squares while they are small, and less beyond `scale`,
/// where they are more likely those of another surface, beyond an edge. A sample that is off by d
/// has the weight (1 + (d / scale)^2)^-power.
struct Robustness {
  double scale = 0.08;
  double power = 1;
};

/// Normal equations of least squares over some of the columns: matrix * step = rhs.
struct NormalEquations {
  std::vector<int> columns;
  Eigen::MatrixXd matrix;
  Eigen::VectorXd rhs;
  /// The sum of the squares as they are.
  double squares = 0;
};

/// Returns the columns of a patch's equations by what changes it: all x, all y, and of those that
/// move colours all r, all g, all b.
std::vector<int> columns_of(const std::vector<Influence>& influences, const Columns& columns);

/// Returns the equations of how the picture of a face and that of the target differ, to first order
/// in the unknowns: by colour at samples over the patch, each weighted by the area around it, and
/// where sides of the patch are outlines by their distance from the target's outlines. At a fixed
/// place of the picture the colour changes with the patch's colours, and with its places as much as
/// colour changes along the way there: so only the gradients of the patch's own colours are needed,
/// and places can do what colours cannot.
NormalEquations normal_equations(const Mesh& mesh, const InfluencedFace& face,
                                 const Columns& columns, const Reference& target);

/// Returns the equations of a patch that the unknowns change by `influences`; `is_outline` says
/// which of its sides are outlines.
NormalEquations normal_equations(const Patch& patch, const std::vector<Influence>& influences,
                                 const std::array<bool, 4>& is_outline, const Columns& columns,
                                 const Reference& target, const Robustness& robustness = {});

/// Solves the sum of the equations. `damping` holds for each column the share of itself by which
/// the diagonal is raised (Levenberg and Marquardt). Returns numbers that are not finite if there
/// is no solution.
Eigen::VectorXd solve(const std::vector<NormalEquations>& parts, const Eigen::VectorXd& damping);

}  // namespace gradmesh
