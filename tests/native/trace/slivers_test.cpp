#include "trace/slivers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "trace/line_fit.h"

namespace gradmesh {
namespace {

constexpr glm::dvec2 sheet(60, 60);

TargetPicture white() {
  TargetPicture target;
  target.width = int(sheet.x);
  target.height = int(sheet.y);
  target.pixels.assign(std::size_t(target.width * target.height), glm::vec4(255));
  return target;
}

/// Three strips of patches, the middle one of which is so many pixels wide.
LineGrid with_strip(double width) {
  LineGrid grid(3, 3, sheet);
  for (int column = 0; column <= 3; ++column) {
    grid.knot(1, column).position.y = 30 - width / 2;
    grid.knot(2, column).position.y = 30 + width / 2;
  }
  return grid;
}

TEST(Slivers, are_thin_or_have_a_sharp_or_flat_corner) {
  const TargetPicture target = white();
  EXPECT_EQ(sliver_squares(LineGrid(4, 7, sheet), target, 1), 0);
  EXPECT_EQ(sliver_squares(with_strip(1.3), target, 1), 0);
  // Across two sides of each of three patches half of a width of 1.2 is lacking.
  EXPECT_NEAR(sliver_squares(with_strip(0.6), target, 10), 10 * 3 * 2 * 0.25, 1e-9);
  LineGrid sharp(1, 2, sheet);
  sharp.knot(0, 1).position.x = 58;
  sharp.knot(1, 1).position.x = 2;
  EXPECT_EQ(sliver_squares(sharp, target, 1), 0);
  LineGrid flat(2, 2, sheet);
  flat.knot(1, 1).position = {1, 1};
  EXPECT_GT(sliver_squares(flat, target, 1), 0);
}

/// The equations' right-hand side is minus half of the gradient of the squares.
TEST(Slivers, know_how_their_squares_change) {
  const TargetPicture target = white();
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> off(-0.4, 0.4);
    LineGrid grid = with_strip(0.5);
    for (int n = 0; n < grid.points(); ++n)
      for (int way = 0; way < grid.knot(n).ways; ++way)
        grid.knot(n).position += off(random) * grid.knot(n).way[std::size_t(way)];
    const GridColumns columns(grid, target);
    Eigen::VectorXd rhs = Eigen::VectorXd::Zero(columns.count());
    double squares = 0;
    for (const NormalEquations& patch : sliver_equations(grid, target, columns, 7)) {
      squares += patch.squares;
      for (std::size_t a = 0; a < patch.columns.size(); ++a)
        rhs(patch.columns[a]) += patch.rhs(Eigen::Index(a));
    }
    EXPECT_NEAR(squares, sliver_squares(grid, target, 7), 1e-9 * squares);
    ASSERT_GT(squares, 0);
    for (int n = 0; n < grid.points(); ++n)
      for (int way = 0; way < grid.knot(n).ways; ++way) {
        constexpr double by = 1e-6;
        LineGrid more = grid, less = grid;
        more.knot(n).position += by * grid.knot(n).way[std::size_t(way)];
        less.knot(n).position -= by * grid.knot(n).way[std::size_t(way)];
        const double slope =
            (sliver_squares(more, target, 7) - sliver_squares(less, target, 7)) / (2 * by);
        EXPECT_NEAR(slope, -2 * rhs(columns.of(n).place[std::size_t(way)]),
                    1e-3 * rhs.cwiseAbs().maxCoeff());
      }
  }
}

TEST(Slivers, become_wider_in_a_fit) {
  const TargetPicture target = white();
  LineGrid grid = with_strip(0.3);
  fit_lines(grid, target, {0, 0, 1e5}, {40, 0});
  EXPECT_LT(sliver_squares(grid, target, 1), 1e-3);
  EXPECT_FALSE(grid.folds());
}

}  // namespace
}  // namespace gradmesh
