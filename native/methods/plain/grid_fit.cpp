#include "methods/plain/grid_fit.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/matrix.hpp>
#include <numeric>
#include <utility>

#include "base/parallel.h"
#include "fit/equation_solver.h"
#include "fit/equations.h"
#include "fit/refit.h"
#include "methods/plain/flaws.h"
#include "raster/folds.h"

namespace gradmesh {
namespace {

/// A mean of FLIP counts a difference about as much as its size, not as its square.
constexpr Robustness by_size = {.scale = 0.02, .power = 0.5};

/// Returns which sides of a patch are on the boundary.
std::array<bool, 4> outlines(const PlainGrid& grid, int row, int column) {
  return {row == 0, column + 1 == grid.columns(), row + 1 == grid.rows(), column == 0};
}

double squares_of(const Patch& patch, const std::array<bool, 4>& are_outlines,
                  const Reference& target) {
  return normal_equations(patch, {}, are_outlines, Columns(0), target, by_size).squares;
}

/// The patches of a grid as a surface of refit(): a step is accepted if it lowers the sum of the
/// squares. What did harm are the unknowns of patches that begin to fold, or lines of which come to
/// touch.
class GridFit {
 public:
  GridFit(PlainGrid& grid, const Reference& target, const GridPoints& points, bool with_colors)
      : grid_(grid),
        target_(target),
        to_mesh_(glm::inverse(target.frame().to_pixels.linear)),
        unknowns_(grid, points, with_colors) {
    list_patches(points);
  }

  double run(int steps) {
    constexpr int attempts = 5;
    now_ = equations(grid_);
    for (steps_left_ = steps; steps_left_-- > 0;) {
      const double before = now_.squares;
      const bool better = refit(*this, attempts);
      if (!is_finite_ || (better && before - now_.squares < little * now_.squares)) break;
      better ? damping_.lower(0) : damping_.raise(0);
    }
    return now_.squares;
  }

  ExpectedSquares expected() {
    now_ = equations(grid_);
    ExpectedSquares result{now_.squares, {}};
    for (const InfluencedPatch& p : patches_) result.patches.push_back({p.row, p.column});
    const Eigen::VectorXd whole = step();
    if (!is_finite_) return result;
    for (const NormalEquations& part : now_.parts) {
      const Eigen::VectorXd own = whole(part.columns);
      result.squares += own.dot(part.matrix * own - 2 * part.rhs);
    }
    return result;
  }

  std::size_t unknown_count() const { return unknowns_.columns().place.size(); }
  Eigen::VectorXd step() {
    const Eigen::VectorXd damping =
        Eigen::VectorXd::Constant(unknowns_.columns().count, damping_.values().front());
    Eigen::VectorXd step = solver_.solve(now_.parts, damping);
    is_finite_ = step.allFinite();
    return step;
  }
  void move(const Eigen::VectorXd& step, const std::vector<bool>& held) {
    if (is_finite_) moved_ = unknowns_.moved(grid_, step, to_mesh_, held);
  }
  void take_back() {}

  Verdict judge(int /*attempt*/) {
    if (!is_finite_) return {};
    if (std::vector<bool> crush = what_crushes(); !crush.empty())
      return {false, true, std::move(crush)};
    Equations then = steps_left_ > 0 ? equations(*moved_) : squares(*moved_);
    if (!(then.squares < now_.squares)) return {};
    grid_ = *std::move(moved_);
    now_ = std::move(then);
    return {.is_accepted = true};
  }

 private:
  /// A step that lowers the sum by less than this share of it is the last.
  static constexpr double little = 2e-3;

  struct Equations {
    std::vector<NormalEquations> parts;
    double squares = 0;
  };

  struct InfluencedPatch {
    int row, column;
    std::vector<Influence> by;
  };

  /// Returns, by unknowns, which change a patch that begins to be crushed; empty if none does.
  std::vector<bool> what_crushes() const {
    std::vector<char> is_crushed(patches_.size());
    parallel_for(patches_.size(), [&](std::size_t n) {
      is_crushed[n] = begins_to_be_crushed(patches_[n].row, patches_[n].column);
    });
    std::vector<bool> crush;
    for (std::size_t n = 0; n < patches_.size(); ++n) {
      if (!is_crushed[n]) continue;
      crush.resize(unknown_count(), false);
      for (const Influence& by : patches_[n].by) crush[std::size_t(by.unknown)] = true;
    }
    return crush;
  }

  bool begins_to_be_crushed(int row, int column) const {
    const Patch before = grid_.patch(row, column), after = moved_->patch(row, column);
    return (may_fold(after) && !may_fold(before)) || is_pinched(after, before);
  }

  /// A patch has the points at its corners, and by the tangents that follow chords those beside
  /// them.
  void list_patches(const GridPoints& points) {
    const GridPoints::Range near = points.bounds();
    const int last_row = std::min(grid_.rows() - 1, near.last_row + 1);
    const int last_column = std::min(grid_.columns() - 1, near.last_column + 1);
    for (int i = std::max(0, near.first_row - 2); i <= last_row; ++i)
      for (int j = std::max(0, near.first_column - 2); j <= last_column; ++j)
        if (std::vector<Influence> by = unknowns_.influences(i, j); !by.empty())
          patches_.push_back({i, j, std::move(by)});
  }

  Equations equations(const PlainGrid& grid) const {
    Equations result;
    const PaintedGrid painted(grid);
    result.parts.resize(patches_.size());
    parallel_for(patches_.size(), [&](std::size_t n) {
      const InfluencedPatch& p = patches_[n];
      result.parts[n] =
          normal_equations(painted.patch(p.row, p.column), p.by, outlines(grid, p.row, p.column),
                           unknowns_.columns(), target_, by_size);
    });
    for (const NormalEquations& part : result.parts) result.squares += part.squares;
    return result;
  }

  /// Returns the sum of the squares alone, which is enough after the last step.
  Equations squares(const PlainGrid& grid) const {
    const PaintedGrid painted(grid);
    std::vector<double> of_patches(patches_.size());
    parallel_for(patches_.size(), [&](std::size_t n) {
      const auto& [row, column, by] = patches_[n];
      of_patches[n] = squares_of(painted.patch(row, column), outlines(grid, row, column), target_);
    });
    return {{}, std::accumulate(of_patches.begin(), of_patches.end(), 0.0)};
  }

  PlainGrid& grid_;
  const Reference& target_;
  const glm::dmat2 to_mesh_;
  const GridUnknowns unknowns_;
  std::vector<InfluencedPatch> patches_;
  EquationSolver solver_;
  /// One for all unknowns.
  Damping damping_{1};
  Equations now_;
  std::optional<PlainGrid> moved_;
  bool is_finite_ = true;
  int steps_left_ = 0;
};

}  // namespace

ExpectedSquares expected_squares(PlainGrid grid, const Reference& target,
                                 const GridPoints& points) {
  return GridFit(grid, target, points, false).expected();
}

double patch_squares(const PaintedGrid& grid, int row, int column, const Reference& target) {
  return squares_of(grid.patch(row, column), outlines(grid.grid(), row, column), target);
}

double fit_grid(PlainGrid& grid, const Reference& target, int steps, const GridPoints& points) {
  return GridFit(grid, target, points, false).run(steps);
}

double fit_grid(PlainGrid& grid, const Reference& target, int steps) {
  return fit_grid(grid, target, steps, GridPoints::all(grid));
}

void fit_grid_and_colors(PlainGrid& grid, const Reference& target, int steps,
                         const GridPoints& points) {
  constexpr double levels = 255, least_change = 1.5;
  PlainGrid free = grid;
  GridFit(free, target, points, true).run(steps);
  points.for_each([&](int i, int j) {
    const glm::dvec4 wanted = free.knot(i, j).color, by = glm::abs(wanted - grid.knot(i, j).color);
    if (std::max({by.r, by.g, by.b}) * levels < least_change) return;
    for (int k = 0; k < 3; ++k) grid.knot(i, j).color[k] = std::round(wanted[k] * levels) / levels;
  });
  fit_grid(grid, target, steps, points);
}

}  // namespace gradmesh
