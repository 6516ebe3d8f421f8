#include "trace/new_line.h"

#include "base/parallel.h"
#include "trace/equations.h"

namespace gradmesh {
namespace {

/// Returns by how much the squares are expected to be less with the line.
double gain_of(const LineGrid& grid, const TargetPicture& target, Along along, int strip) {
  // A step of points alone ends before it is whole: lines beside it are in the way.
  constexpr double place_damping = 0.3;
  const LineGrid finer = grid.with_line(along, strip);
  const GridColumns columns(finer, target, along, strip + 1, strip + 1);
  const bool is_row = along == Along::rows;
  std::vector<NormalEquations> parts;
  for (const int line : {strip, strip + 1})
    for (int k = 0; k < (is_row ? grid.columns() : grid.rows()); ++k)
      parts.push_back(
          patch_equations(finer, is_row ? line : k, is_row ? k : line, target, columns));
  Eigen::VectorXd damping = Eigen::VectorXd::Zero(columns.count());
  Eigen::VectorXd rhs = damping;
  for (int number = 0; number < finer.points(); ++number)
    for (const int column : {columns.of(number).x, columns.of(number).y})
      if (column >= 0) damping(column) = place_damping;
  for (const NormalEquations& part : parts)
    for (std::size_t a = 0; a < part.columns.size(); ++a)
      rhs(part.columns[a]) += part.rhs(Eigen::Index(a));
  const Eigen::VectorXd step = solve(parts, damping);
  return step.allFinite() ? rhs.dot(step) : 0;
}

}  // namespace

std::optional<NewLine> best_new_line(const LineGrid& grid, const TargetPicture& target,
                                     const MostLines& most) {
  std::vector<NewLine> lines;
  if (grid.rows() < most.rows && (grid.rows() + 2) * (grid.columns() + 1) <= most.points)
    for (int i = 0; i < grid.rows(); ++i) lines.push_back({Along::rows, i});
  if (grid.columns() < most.columns && (grid.rows() + 1) * (grid.columns() + 2) <= most.points)
    for (int j = 0; j < grid.columns(); ++j) lines.push_back({Along::columns, j});
  parallel_for(lines.size(), [&](std::size_t n) {
    NewLine& line = lines[n];
    const int points = 1 + (line.along == Along::rows ? grid.columns() : grid.rows());
    line.gain = gain_of(grid, target, line.along, line.strip) / points;
  });
  std::optional<NewLine> best;
  for (const NewLine& line : lines)
    if (!best || line.gain > best->gain) best = line;
  return best;
}

}  // namespace gradmesh
