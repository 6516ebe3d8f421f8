#include "trace/thinned_grids.h"

#include <optional>

#include "trace/line_changes.h"
#include "trace/line_fit.h"

namespace gradmesh {
std::vector<LineGrid> thinned_grids(const LineGrid& grid, const TargetPicture& target,
                                    StopWatch& watch) {
  constexpr FitLength to_the_end{40, 5e-4};
  // With what the grid was fitted at last, so that a fit goes on where that one ended.
  const Evenness faint = Evenness().loosest();
  double squares = squares_of(grid, target);
  std::vector<LineGrid> grids;
  LineGrid left = grid;
  const auto points = std::size_t(grid.points());
  while (!watch.should_stop({points - std::size_t(left.points()), points,
                             left.rows() * left.columns(), 0, left.points()})) {
    const std::optional<LineChange> line =
        cheapest_line(left, target, faint.for_patches(squares / left.patches()).slivers);
    if (!line) break;
    left = left.without_line(line->along, line->number);
    squares = fit_lines(left, target, faint, to_the_end);
    grids.push_back(left.in_whole_levels());
  }
  return grids;
}

}  // namespace gradmesh
