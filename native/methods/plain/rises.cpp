#include "methods/plain/rises.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

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

/// Returns the patches beside a side.
std::vector<PatchPlace> patches_beside(const PlainGrid& grid, const Side& side) {
  const int above = side.along == Along::rows, left = side.along == Along::columns;
  std::vector<PatchPlace> places;
  for (const auto& [i, j] :
       {PatchPlace{side.row, side.column}, PatchPlace{side.row - above, side.column - left}})
    if (i >= 0 && j >= 0 && i < grid.rows() && j < grid.columns()) places.push_back({i, j});
  return places;
}

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

std::vector<double> rises_if_straight(const PlainGrid& grid, const std::vector<Side>& sides,
                                      const Reference& target) {
  std::vector<PatchPlace> patches;
  for (const Side& side : sides)
    for (const PatchPlace& place : patches_beside(grid, side)) patches.push_back(place);
  std::ranges::sort(patches);
  patches.erase(std::unique(patches.begin(), patches.end()), patches.end());
  std::vector<double> squares(patches.size());
  const PaintedGrid painted(grid);
  parallel_for(patches.size(), [&](std::size_t n) {
    squares[n] = patch_squares(painted, patches[n].row, patches[n].column, target);
  });

  std::vector<double> rises(sides.size(), 0);
  // A copy of the grid for each thread.
  const std::size_t shares = std::min(thread_count(), sides.size());
  parallel_for(shares, [&](std::size_t share) {
    PlainGrid straight = grid;
    // Sides that become straight change no colours.
    const PaintedGrid painted_straight(straight);
    for (std::size_t n = share; n < sides.size(); n += shares) {
      const Side& side = sides[n];
      PlainGrid::Bend& bend = straight.bend(side.along, side.row, side.column);
      const PlainGrid::Bend curve = std::exchange(bend, std::nullopt);
      for (const PatchPlace& place : patches_beside(grid, side)) {
        const auto known = std::ranges::lower_bound(patches, place) - patches.begin();
        rises[n] += patch_squares(painted_straight, place.row, place.column, target) -
                    squares[std::size_t(known)];
      }
      bend = curve;
    }
  });
  return rises;
}

}  // namespace gradmesh
