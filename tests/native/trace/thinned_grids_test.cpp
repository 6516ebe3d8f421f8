#include "trace/thinned_grids.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/common.hpp>

#include "base/parallel.h"
#include "trace/line_fit.h"
#include "trace/traced_grid.h"

namespace gradmesh {
namespace {

/// A soft picture that needs some lines in both directions.
TargetPicture waves() {
  TargetPicture target;
  target.width = 80;
  target.height = 60;
  for (int y = 0; y < target.height; ++y)
    for (int x = 0; x < target.width; ++x)
      target.pixels.emplace_back(128 + 100 * std::sin(x / 9.0), 128 + 90 * std::cos(y / 8.0), x + y,
                                 255);
  return target;
}

LineGrid grid_of(const TargetPicture& target, int points) {
  StopWatch watch(0, {});
  return traced_grid({{&target, LineGrid(2, 2, {80, 60})}}, points, watch).grid;
}

std::vector<LineGrid> thinned(const LineGrid& grid, const TargetPicture& target) {
  StopWatch watch(0, {});
  return thinned_grids(grid, target, watch);
}

TEST(ThinnedGrids, lose_a_line_each_until_there_is_none) {
  const TargetPicture target = waves();
  const LineGrid grid = grid_of(target, 100);
  const std::vector<LineGrid> grids = thinned(grid, target);
  ASSERT_EQ(int(grids.size()), grid.rows() + grid.columns() - 2);
  int lines = grid.rows() + grid.columns();
  double squares = squares_of(grid, target);
  for (const LineGrid& left : grids) {
    EXPECT_EQ(left.rows() + left.columns(), --lines);
    EXPECT_EQ(left.size(), grid.size());
    EXPECT_GT(squares_of(left, target), 0.9 * squares);
    squares = squares_of(left, target);
    for (int n = 0; n < left.points(); ++n)
      EXPECT_EQ(left.knot(n).color, glm::round(left.knot(n).color));
  }
  EXPECT_EQ(grids.back().points(), 4);
}

TEST(ThinnedGrids, are_fitted_again) {
  const TargetPicture target = waves();
  const LineGrid grid = grid_of(target, 100);
  const std::vector<LineGrid> grids = thinned(grid, target);
  // Of the same lines, fitted for longer from the same place.
  LineGrid longer = grids[3];
  fit_lines(longer, target, Evenness().loosest(), {40, 1e-5});
  EXPECT_LT(squares_of(grids[3], target), 1.1 * squares_of(longer, target));
}

TEST(ThinnedGrids, end_where_they_are_told_to) {
  const TargetPicture target = waves();
  const LineGrid grid = grid_of(target, 100);
  const auto until = [&](int calls) {
    StopWatch watch(0, [&](const Progress&) { return --calls >= 0; });
    return thinned_grids(grid, target, watch);
  };
  const std::vector<LineGrid> all = thinned(grid, target);
  EXPECT_EQ(until(0).size(), 0u);
  EXPECT_EQ(until(3), std::vector(all.begin(), all.begin() + 3));
  EXPECT_EQ(thinned(LineGrid(1, 1, {80, 60}), target).size(), 0u);
}

TEST(ThinnedGrids, is_the_same_on_any_number_of_threads) {
  const TargetPicture target = waves();
  const LineGrid grid = grid_of(target, 60);
  const std::vector<LineGrid> some = thinned(grid, target);
  const ThreadLimit one(1);
  EXPECT_EQ(thinned(grid, target), some);
}

}  // namespace
}  // namespace gradmesh
