#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "formats/pdf/grid/page_grids.h"
#include "formats/pdf/grid/without_anchors.h"
#include "page_sheets.h"

namespace gradmesh {
namespace {

constexpr double tolerance = 1e-3;
constexpr int rows = 3, columns = 4;

/// A patch of the sheet with zero twist, as Illustrator's are.
PagePatch zero_twist_patch(int row, int column) {
  PagePatch patch = Sheet(rows, columns).patch(row, column);
  for (std::size_t k = 0; k < 4; ++k)
    patch.inner[k] = patch.outer[3 * k + 1] + patch.outer[(3 * k + 11) % 12] - patch.outer[3 * k];
  return patch;
}

/// Adds a patch, or its parts, divided at any places and these again.
void add_divided(const PagePatch& patch, int depth, std::mt19937& random,
                 std::vector<PagePatch>& patches) {
  if (depth == 0 || random() % 4 == 0) {
    patches.push_back(laid(patch, {0, int(random() % 4), random() % 2 == 0}));
    return;
  }
  const double share = random() % 4 == 0 ? 0.5 : std::uniform_real_distribution(0.2, 0.8)(random);
  for (const PagePatch& part : divided(patch.turned(random() % 2), share))
    add_divided(part, depth - 1, random, patches);
}

/// Whatever lies beside it: other patches that are divided elsewhere, or the boundary.
TEST(WithoutAnchors, DividedPatchesAreWholeAgain) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    std::mt19937 random(seed);
    std::vector<PagePatch> patches, wanted;
    for (int i = 0; i < rows; ++i)
      for (int j = 0; j < columns; ++j) {
        wanted.push_back(zero_twist_patch(i, j));
        // Patches that are never divided keep lines from going from side to side.
        add_divided(wanted.back(), i == 1 || j == 1 ? 0 : 3, random, patches);
      }
    std::ranges::shuffle(patches, random);
    const JoinedPatches joined = without_anchors(patches, tolerance);
    ASSERT_EQ(joined.patches.size(), wanted.size()) << seed;
    EXPECT_LT(joined.distance, 1e-5);
    for (const PagePatch& patch : joined.patches) {
      const bool is_one = std::ranges::any_of(wanted, [&](const PagePatch& each) {
        for (int n = 0; n < 8; ++n) {
          const PagePatch other = laid(each, {0, n % 4, n > 3});
          const auto is_close = [](glm::dvec2 a, glm::dvec2 b) {
            return glm::distance(a, b) < 1e-5;
          };
          if (std::ranges::equal(patch.outer, other.outer, is_close) &&
              std::ranges::equal(patch.inner, other.inner, is_close))
            return patch.colors == other.colors;
        }
        return false;
      });
      EXPECT_TRUE(is_one) << seed;
    }
  }
}

/// The sheet with one patch divided, whose anchor is moved, but not its handles.
std::vector<PagePatch> with_moved_anchor(glm::dvec2 by) {
  std::vector<PagePatch> patches;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j)
      if (i > 0 || j != 1) patches.push_back(zero_twist_patch(i, j));
  auto parts = divided(zero_twist_patch(0, 1), 0.4);
  parts[0].outer[3] += by;
  parts[1].outer[0] += by;
  patches.insert(patches.end(), parts.begin(), parts.end());
  return patches;
}

TEST(WithoutAnchors, SidesOfTwoCurvesBecomeTheClosest) {
  const JoinedPatches joined = without_anchors(with_moved_anchor({0, 0.8}), tolerance);
  EXPECT_EQ(joined.patches.size(), std::size_t(rows * columns));
  EXPECT_EQ(page_grids(PatchSides(joined.patches, tolerance)).size(), 1U);
  EXPECT_GT(joined.distance, 0.1);
  EXPECT_LT(joined.distance, 0.8);
}

TEST(WithoutAnchors, WhatBendsTooMuchStays) {
  const std::vector<PagePatch> patches = with_moved_anchor({0, 9});
  EXPECT_TRUE(without_anchors(patches, tolerance).patches == patches);
}

TEST(WithoutAnchors, WhatIsNoGridStays) {
  std::vector<PagePatch> patches = with_moved_anchor({0, 0});
  EXPECT_EQ(without_anchors(patches, tolerance).patches.size(), patches.size() - 1);
  patches.erase(patches.begin());
  EXPECT_TRUE(without_anchors(patches, tolerance).patches == patches);
}

/// Rectangles between few points, some of which are lines or points, lie over each other in any
/// way.
TEST(WithoutAnchors, AnyPatchesGiveFinitePoints) {
  for (unsigned seed = 0; seed < 1000; ++seed) {
    std::mt19937 random(seed);
    std::vector<PagePatch> patches;
    for (int n = 2 + int(random() % 14); n > 0; --n) {
      const glm::dvec2 from(random() % 4, random() % 4), to(random() % 4, random() % 4);
      patches.push_back(rectangular_patch(from, to));
    }
    for (const PagePatch& patch : without_anchors(patches, tolerance).patches)
      for (const glm::dvec2 point : patch.outer)
        EXPECT_TRUE(std::isfinite(point.x) && std::isfinite(point.y)) << seed;
  }
}

}  // namespace
}  // namespace gradmesh
