#include "trace/line_fit.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>

#include "base/parallel.h"
#include "fit/equation_solver.h"
#include "trace/slivers.h"

namespace gradmesh {
namespace {

/// Calls `f(n, row, column)` for the n-th patch of a grid, row by row, in parallel.
template <class F>
void for_each_patch(const LineGrid& grid, const F& f) {
  const auto columns = std::size_t(grid.columns());
  parallel_for(std::size_t(grid.rows()), [&](std::size_t i) {
    for (std::size_t k = 0; k < columns; ++k) f(i * columns + k, int(i), int(k));
  });
}

std::size_t patch_count(const LineGrid& grid) { return std::size_t(grid.patches()); }

/// Returns the largest share, 0..1, of a way that a point can go without making a corner around it
/// smaller than a tenth of what it was, or than `least_area`. Each corner's area is linear in the
/// way.
double allowed_share(LineGrid& grid, int row, int column, glm::dvec2 way, double least_area) {
  constexpr double least_share = 0.1;
  LineGrid::Knot& knot = grid.knot(row, column);
  const glm::dvec2 start = knot.position;
  double share = 1;
  for (int i = std::max(0, row - 1); i <= std::min(row, grid.rows() - 1); ++i)
    for (int j = std::max(0, column - 1); j <= std::min(column, grid.columns() - 1); ++j)
      for (int corner = 0; corner < 4; ++corner) {
        const double before = grid.corner_area(i, j, corner);
        knot.position = start + way;
        const double after = grid.corner_area(i, j, corner);
        knot.position = start;
        const double least = std::min(before, std::max(least_area, least_share * before));
        if (after < least) share = std::min(share, (before - least) / (before - after));
      }
  return std::max(0.0, share);
}

/// Slides a point that is on a guide along it, about as far as a way that is as long, or less far
/// where a corner would become too small because the guide bends.
void slide(LineGrid& grid, int row, int column, glm::dvec2 way, double least_area) {
  constexpr int tries = 6;
  const LineGrid::Knot before = grid.knot(row, column);
  if (before.is_held()) return;
  const Along along = before.follows(Along::rows) ? Along::rows : Along::columns;
  const LineGrid::OnGuide on = before.on_guide(along);
  double ahead = glm::dot(way, before.way[0]);
  for (int i = 0; i < tries; ++i, ahead /= 2) {
    grid.put_on_guide(grid.number(row, column), along, {on.guide, on.way + ahead});
    const LineGrid::Knot after = grid.knot(row, column);
    grid.knot(row, column) = before;
    const glm::dvec2 moved = after.position - before.position;
    if (allowed_share(grid, row, column, moved, least_area) < 1) continue;
    grid.knot(row, column) = after;
    return;
  }
}

/// Returns the equations of a channel of a patch in which colours at the ends of a side cost a
/// little where they differ: so that a colour which hardly a pixel shows is that of its neighbours.
NormalEquations drawn_together(NormalEquations patch, const LineGrid& grid, int channel) {
  constexpr double weight = 0.005, hold = 1e-6;
  Eigen::Vector4d levels;
  for (int k = 0; k < 4; ++k) levels(k) = grid.knot(patch.columns[std::size_t(k)]).color[channel];
  Eigen::Matrix4d apart = 2 * Eigen::Matrix4d::Identity();
  for (int k = 0; k < 4; ++k) apart(k, (k + 1) % 4) = apart((k + 1) % 4, k) = -1;
  patch.matrix += weight * apart;
  patch.rhs -= weight * apart * levels;
  patch.matrix.diagonal().array() += hold;
  return patch;
}

/// Changes a channel of all points by least squares of the patches' equations. Returns the sum of
/// the squares that is left, which is a square of what changes.
double fit_channel(LineGrid& grid, int channel, const std::vector<NormalEquations>& patches,
                   EquationSolver& solver) {
  std::vector<NormalEquations> drawn;
  drawn.reserve(patches.size());
  for (const NormalEquations& patch : patches)
    drawn.push_back(drawn_together(patch, grid, channel));
  Eigen::VectorXd step = solver.solve(drawn, Eigen::VectorXd::Zero(grid.points()));
  if (!step.allFinite()) step.setZero();
  for (int number = 0; number < grid.points(); ++number) {
    double& level = grid.knot(number).color[channel];
    const double before = level;
    level = std::clamp(before + step(number), 0.0, 255.0);
    step(number) = level - before;
  }
  double squares = 0;
  for (const NormalEquations& patch : patches) {
    Eigen::Vector4d change;
    for (int k = 0; k < 4; ++k) change(k) = step(patch.columns[std::size_t(k)]);
    squares += patch.squares - change.dot(2 * patch.rhs - patch.matrix * change);
  }
  return squares;
}

/// `solver` is for grids of this size.
double fit_colors(LineGrid& grid, const TargetPicture& target, EquationSolver& solver) {
  const auto count = std::size_t(channels(target));
  std::vector<std::vector<NormalEquations>> parts(count,
                                                  std::vector<NormalEquations>(patch_count(grid)));
  for_each_patch(grid, [&](std::size_t n, int row, int column) {
    std::vector<NormalEquations> of_patch = channel_equations(grid, row, column, target);
    for (std::size_t channel = 0; channel < count; ++channel)
      parts[channel][n] = std::move(of_patch[channel]);
  });
  solver.prepare(parts.front(), grid.points());
  std::vector<double> squares(count);
  parallel_for(count, [&](std::size_t channel) {
    squares[channel] = fit_channel(grid, int(channel), parts[channel], solver);
  });
  return std::accumulate(squares.begin(), squares.end(), 0.0);
}

/// One fit: Levenberg and Marquardt, with a damping for all places.
class LineFit {
 public:
  LineFit(LineGrid& grid, const TargetPicture& target, const Evenness& evenness)
      : grid_(grid), target_(target), evenness_(evenness), columns_(grid, target) {}

  double run(FitLength length) {
    squares_ = fit_colors(grid_, target_, of_colors_);
    evenness_ = evenness_.for_patches(squares_ / grid_.patches());
    uneven_ = unevenness(grid_);
    for (int step = 0; step < length.steps && damping_ < length.most_damping; ++step) {
      const double before = squares_ + uneven_;
      if (make_step() && before - squares_ - uneven_ < length.little * before) break;
    }
    return squares_;
  }

 private:
  static constexpr double least_damping = 1e-4;

  /// Returns true if the step was accepted.
  bool make_step() {
    const Eigen::VectorXd step = this->step();
    if (!step.allFinite()) return raise_damping();
    LineGrid moved = grid_;
    move(moved, step);
    const double squares = fit_colors(moved, target_, of_colors_);
    const double uneven = unevenness(moved);
    if (!(squares + uneven < squares_ + uneven_)) return raise_damping();
    grid_ = std::move(moved);
    equations_.clear();
    squares_ = squares;
    uneven_ = uneven;
    damping_ = std::max(least_damping, damping_ / 4);
    return true;
  }

  double unevenness(const LineGrid& grid) const {
    return gradmesh::unevenness(grid, target_, evenness_) +
           sliver_squares(grid, target_, evenness_.slivers);
  }

  bool raise_damping() {
    damping_ *= 8;
    return false;
  }

  void find_equations() {
    equations_.resize(patch_count(grid_));
    for_each_patch(grid_, [&](std::size_t n, int row, int column) {
      equations_[n] = patch_equations(grid_, row, column, target_, columns_);
    });
    for (NormalEquations& part : evenness_equations(grid_, target_, columns_, evenness_))
      equations_.push_back(std::move(part));
    for (NormalEquations& part : sliver_equations(grid_, target_, columns_, evenness_.slivers))
      equations_.push_back(std::move(part));
  }

  /// Returns by how much to change what the columns number.
  Eigen::VectorXd step() {
    if (equations_.empty()) find_equations();
    Eigen::VectorXd damping = Eigen::VectorXd::Zero(columns_.count());
    for (int number = 0; number < grid_.points(); ++number)
      for (const int column : columns_.of(number).place)
        if (column >= 0) damping(column) = damping_;
    return of_all_.solve(equations_, damping);
  }

  /// Moves the points as far as patches do not fold: one set of points after the other that have no
  /// patch in common, so that each only needs to look at neighbours that rest.
  void move(LineGrid& grid, const Eigen::VectorXd& step) const {
    const glm::dvec2 scale = pixels_per_unit(grid, target_);
    const double least_area = evenness_.least_corner / (scale.x * scale.y);
    for (const int first_row : {0, 1})
      for (const int first_column : {0, 1})
        for (int i = first_row; i <= grid.rows(); i += 2)
          for (int j = first_column; j <= grid.columns(); j += 2) {
            LineGrid::Knot& knot = grid.knot(i, j);
            const KnotColumns& of = columns_.of(grid.number(i, j));
            glm::dvec2 way(0.0);
            for (std::size_t k = 0; k < of.place.size(); ++k)
              if (of.place[k] >= 0) way += step(of.place[k]) * way_in_pixels(knot, k, scale);
            way /= scale;
            way *= allowed_share(grid, i, j, way, least_area);
            if (knot.follows(Along::rows) || knot.follows(Along::columns))
              slide(grid, i, j, way, least_area);
            else
              knot.position += way;
          }
  }

  LineGrid& grid_;
  const TargetPicture& target_;
  Evenness evenness_;
  const GridColumns columns_;
  /// Those of the grid as it is; none before they are asked for.
  std::vector<NormalEquations> equations_;
  EquationSolver of_all_, of_colors_;
  double squares_ = 0, uneven_ = 0, damping_ = 1e-2;
};

}  // namespace

double fit_colors(LineGrid& grid, const TargetPicture& target) {
  EquationSolver solver;
  return fit_colors(grid, target, solver);
}

double squares_of(const LineGrid& grid, const TargetPicture& target) {
  std::vector<double> of_patches(patch_count(grid));
  for_each_patch(grid, [&](std::size_t n, int row, int column) {
    of_patches[n] = patch_squares(grid, row, column, target);
  });
  return std::accumulate(of_patches.begin(), of_patches.end(), 0.0);
}

double fit_lines(LineGrid& grid, const TargetPicture& target, const Evenness& evenness,
                 FitLength length) {
  return LineFit(grid, target, evenness).run(length);
}

}  // namespace gradmesh
