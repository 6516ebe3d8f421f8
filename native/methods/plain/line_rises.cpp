#include "methods/plain/line_rises.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "methods/plain/grid_fit.h"

namespace gradmesh {
namespace {

/// The squares of each patch of a grid.
class PatchSquares {
 public:
  PatchSquares(const PlainGrid& grid, const Reference& target) : columns_(grid.columns()) {
    std::vector<PatchPlace> places;
    for (int i = 0; i < grid.rows(); ++i)
      for (int j = 0; j < columns_; ++j) places.push_back({i, j});
    squares_.resize(places.size());
    const PaintedGrid painted(grid);
    parallel_for(places.size(), [&](std::size_t n) {
      squares_[n] = patch_squares(painted, places[n].row, places[n].column, target);
    });
  }

  /// Returns the squares of what a patch of the grid without the line lies on.
  double under(PatchPlace place, const Step& line) const {
    const bool is_row = line.along == Along::rows;
    const int number = is_row ? place.row : place.column;
    const int first = number >= line.line, last = number >= line.line - 1;
    double sum = 0;
    for (int by = first; by <= last; ++by)
      sum += at(place.row + (is_row ? by : 0), place.column + (is_row ? 0 : by));
    return sum;
  }

 private:
  double at(int row, int column) const { return squares_[std::size_t(row * columns_ + column)]; }

  int columns_;
  std::vector<double> squares_;
};

}  // namespace

std::vector<LineRise> rises_without(const PlainGrid& grid, const std::vector<Step>& lines,
                                    const Reference& target) {
  const PatchSquares before(grid, target);
  std::vector<LineRise> rises(lines.size());
  parallel_for(lines.size(), [&](std::size_t n) {
    PlainGrid without = grid;
    make(lines[n], without);
    rises[n].saved = grid.handles() - without.handles();
    const GridPoints points = points_near(lines[n], without);
    const ExpectedSquares after = expected_squares(std::move(without), target, points);
    double rise = after.squares;
    for (const PatchPlace& place : after.patches) rise -= before.under(place, lines[n]);
    rises[n].root = std::sqrt(std::max(0.0, rise));
  });
  return rises;
}

}  // namespace gradmesh
