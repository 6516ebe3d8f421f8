#include "trace/line_changes.h"

#include <algorithm>
#include <limits>

#include "base/parallel.h"
#include "trace/equations.h"
#include "trace/guide_stray.h"
#include "trace/slivers.h"

namespace gradmesh {
namespace {

/// Strips of patches of a grid, along rows or columns, from one to another, both included.
struct Strips {
  Along along;
  int first, last;
};

Strips within(const LineGrid& grid, Strips strips) {
  const int count = strips.along == Along::rows ? grid.rows() : grid.columns();
  return {strips.along, std::max(0, strips.first), std::min(count - 1, strips.last)};
}

/// Calls `f(row, column)` for the patches of strips.
template <class F>
void for_each_patch(const LineGrid& grid, const Strips& strips, const F& f) {
  const bool are_rows = strips.along == Along::rows;
  const int length = are_rows ? grid.columns() : grid.rows();
  for (int line = strips.first; line <= strips.last; ++line)
    for (int k = 0; k < length; ++k) are_rows ? f(line, k) : f(k, line);
}

/// The squares of strips as they are, and as they are expected to be after one step of
/// Gauss-Newton.
struct Expected {
  double before = 0, after = 0;
};

Expected expected_squares(const LineGrid& grid, const TargetPicture& target, const Strips& strips,
                          const GridColumns& columns) {
  // A step of points alone ends before it is whole: lines beside it are in the way.
  constexpr double place_damping = 0.3;
  std::vector<NormalEquations> parts;
  Expected result;
  Eigen::VectorXd damping = Eigen::VectorXd::Zero(columns.count()), rhs = damping;
  for_each_patch(grid, strips, [&](int row, int column) {
    const NormalEquations& part =
        parts.emplace_back(patch_equations(grid, row, column, target, columns));
    result.before += part.squares;
    for (std::size_t a = 0; a < part.columns.size(); ++a)
      rhs(part.columns[a]) += part.rhs(Eigen::Index(a));
  });
  for (int number = 0; number < grid.points(); ++number)
    for (const int column : columns.of(number).place)
      if (column >= 0) damping(column) = place_damping;
  const Eigen::VectorXd step = solve(parts, damping);
  result.after = result.before - (step.allFinite() ? rhs.dot(step) : 0);
  return result;
}

bool folds(const LineGrid& grid, const Strips& strips) {
  bool any = false;
  for_each_patch(grid, strips, [&](int row, int column) {
    for (int corner = 0; corner < 4; ++corner)
      any = any || !(grid.corner_area(row, column, corner) > 0);
  });
  return any;
}

double squares_of_strips(const LineGrid& grid, const TargetPicture& target, const Strips& strips) {
  double squares = 0;
  for_each_patch(grid, strips,
                 [&](int row, int column) { squares += patch_squares(grid, row, column, target); });
  return squares;
}

/// Returns the squares of a grid that no patch has alone.
double other_squares(const LineGrid& grid, const TargetPicture& target, double slivers) {
  return stray_squares(grid, target) + sliver_squares(grid, target, slivers);
}

/// Returns what a line through a strip gains; less than nothing where a patch would fold.
double gain_of(const LineGrid& grid, const TargetPicture& target, double slivers, Along along,
               int strip) {
  const LineGrid finer = grid.with_line(along, strip);
  const Strips after{along, strip, strip + 1};
  const bool has_guides = !grid.guides().empty();
  if (has_guides && folds(finer, after)) return -std::numeric_limits<double>::infinity();
  const Expected expected = expected_squares(
      finer, target, after, GridColumns(finer, target, along, strip + 1, strip + 1));
  // Where the line crosses a guide the grid does not look the same with it.
  const double before =
      has_guides ? squares_of_strips(grid, target, {along, strip, strip}) : expected.before;
  return before + other_squares(grid, target, slivers) - expected.after -
         other_squares(finer, target, slivers);
}

/// Returns what it costs to take a line out; infinity where a patch would fold.
double cost_of(const LineGrid& grid, const TargetPicture& target, double slivers, Along along,
               int line) {
  const LineGrid coarser = grid.without_line(along, line);
  const Strips after = within(coarser, {along, line - 2, line});
  if (folds(coarser, after)) return std::numeric_limits<double>::infinity();
  const double before = squares_of_strips(grid, target, within(grid, {along, line - 2, line + 1}));
  const Expected expected =
      expected_squares(coarser, target, after, GridColumns(coarser, target, along, line - 1, line));
  return expected.after + other_squares(coarser, target, slivers) - before -
         other_squares(grid, target, slivers);
}

}  // namespace

std::optional<LineChange> best_new_line(const LineGrid& grid, const TargetPicture& target,
                                        const MostLines& most, double slivers) {
  std::vector<LineChange> lines;
  if (grid.rows() < most.rows && (grid.rows() + 2) * (grid.columns() + 1) <= most.points)
    for (int i = 0; i < grid.rows(); ++i) lines.push_back({Along::rows, i});
  if (grid.columns() < most.columns && (grid.rows() + 1) * (grid.columns() + 2) <= most.points)
    for (int j = 0; j < grid.columns(); ++j) lines.push_back({Along::columns, j});
  parallel_for(lines.size(), [&](std::size_t n) {
    LineChange& line = lines[n];
    line.squares =
        gain_of(grid, target, slivers, line.along, line.number) / grid.points_along(line.along);
  });
  const auto best = std::ranges::max_element(lines, {}, &LineChange::squares);
  return best == lines.end() ? std::nullopt : std::optional(*best);
}

std::optional<LineChange> cheapest_line(const LineGrid& grid, const TargetPicture& target,
                                        double slivers) {
  std::vector<LineChange> lines;
  for (const Along along : {Along::rows, Along::columns})
    for (int line = 1; line < (along == Along::rows ? grid.rows() : grid.columns()); ++line)
      if (grid.can_lose(along, line)) lines.push_back({along, line});
  parallel_for(lines.size(), [&](std::size_t n) {
    LineChange& line = lines[n];
    line.squares =
        cost_of(grid, target, slivers, line.along, line.number) / grid.points_along(line.along);
  });
  const auto best = std::ranges::min_element(lines, {}, &LineChange::squares);
  const bool is_there =
      best != lines.end() && best->squares < std::numeric_limits<double>::infinity();
  return is_there ? std::optional(*best) : std::nullopt;
}

}  // namespace gradmesh
