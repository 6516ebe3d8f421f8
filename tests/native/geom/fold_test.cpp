#include "geom/fold.h"

#include <gtest/gtest.h>

#include "geom/convex_hull.h"
#include "geom/cross.h"

namespace gradmesh {
namespace {

/// A bilinear patch with these corners, of which the second follows the first along v.
Patch patch_of(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 d) {
  BezierNet net;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      const double u = double(i) / 3, v = double(j) / 3;
      net[i][j].position = (1 - u) * ((1 - v) * a + v * b) + u * ((1 - v) * d + v * c);
    }
  return patch_from_bezier(net);
}

const Patch square = patch_of({0, 0}, {9, 0}, {9, 9}, {0, 9});
/// Two triangles that meet where its sides cross: its outline turns once to the right and once to
/// the left.
const Patch bow = patch_of({0, 0}, {9, 0}, {0, 9}, {9, 9});

TEST(Fold, IsWhereAPatchTurnsToItsOtherSide) {
  EXPECT_FALSE(folds(square));
  EXPECT_FALSE(folds(patch_of({0, 9}, {9, 9}, {9, 0}, {0, 0})));
  EXPECT_TRUE(folds(bow));
  // A triangle has a corner without a size.
  EXPECT_FALSE(folds(patch_of({0, 0}, {9, 0}, {9, 9}, {9, 9})));
}

TEST(Fold, CellsCoverBothSheets) {
  const FilledOutline area{covered_cells(bow)};
  EXPECT_TRUE(contains(area, {4.4, 1}));
  EXPECT_TRUE(contains(area, {4.4, 8}));
  EXPECT_FALSE(contains(area, {1, 4.4}));
  EXPECT_FALSE(contains(area, {8, 4.4}));
  const FilledOutline whole{covered_cells(square)};
  for (double x = 0.3; x < 9; x += 0.7)
    for (double y = 0.3; y < 9; y += 0.7) EXPECT_TRUE(contains(whole, {x, y}));
}

TEST(ConvexHull, IsClockwiseAroundAllPoints) {
  const std::vector<glm::dvec2> hull =
      convex_hull({{1, 1}, {0, 0}, {2, 0}, {1, 0.5}, {2, 2}, {0, 2}, {1, 2}});
  ASSERT_EQ(hull.size(), 4U);
  for (std::size_t n = 0; n < 4; ++n)
    EXPECT_GT(cross(hull[(n + 1) % 4] - hull[n], hull[(n + 2) % 4] - hull[(n + 1) % 4]), 0);
}

}  // namespace
}  // namespace gradmesh
