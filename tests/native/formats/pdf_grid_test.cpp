#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <random>
#include <set>

#include "formats/pdf/grid/joined_halves.h"
#include "formats/pdf/grid/page_grids.h"
#include "page_sheets.h"

namespace gradmesh {
namespace {

constexpr double tolerance = 1e-3;

std::vector<PageGrid> grids(const std::vector<PagePatch>& patches) {
  return page_grids(PatchSides(patches, tolerance));
}

std::vector<int> numbers(const PageGrid& grid) {
  std::vector<int> numbers;
  for (const LaidPatch& lies : grid.patches) numbers.push_back(lies.patch);
  return numbers;
}

/// Checks that neighbours share sides as a grid's do.
void expect_joined(const PageGrid& grid, const PatchSides& sides) {
  ASSERT_EQ(grid.patches.size(), std::size_t(grid.rows * grid.columns));
  const auto at = [&](int row, int column) {
    const LaidPatch& lies = grid.patches[std::size_t(row * grid.columns + column)];
    return laid(sides.patches()[std::size_t(lies.patch)], lies);
  };
  for (int i = 0; i < grid.rows; ++i)
    for (int j = 0; j < grid.columns; ++j)
      for (std::size_t n = 0; n < 4; ++n) {
        if (j + 1 < grid.columns) {
          EXPECT_EQ(at(i, j).side_point(1, n), at(i, j + 1).side_point(3, 3 - n));
        }
        if (i + 1 < grid.rows) {
          EXPECT_EQ(at(i, j).side_point(2, n), at(i + 1, j).side_point(0, 3 - n));
        }
      }
}

TEST(WeldedPoints, ClosePointsAreOneWhereverCellsEnd) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> anywhere(-5, 5), close(-0.9 * tolerance, 0.9 * tolerance);
  for (int n = 0; n < 500; ++n) {
    WeldedPoints points(tolerance);
    const glm::dvec2 point(anywhere(random), anywhere(random));
    const int number = points.number(point);
    EXPECT_EQ(points.number(point + glm::dvec2(close(random), close(random))), number);
    EXPECT_NE(points.number(point + glm::dvec2(1.5 * tolerance, 0)), number);
    EXPECT_EQ(points.point(number), point);
  }
}

TEST(PageGrids, RowsAndColumnsAreThoseOfTheFirstPatch) {
  const auto found = grids(Sheet(3, 5).patches());
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].rows, 3);
  EXPECT_EQ(found[0].columns, 5);
  for (std::size_t n = 0; n < 15; ++n) EXPECT_EQ(found[0].patches[n], LaidPatch{int(n)});
}

/// Whatever the order of patches is, and from which corner and which way each is listed.
TEST(PageGrids, OrderAndListingDoNotMatter) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    std::mt19937 random(seed);
    const int rows = 1 + int(random() % 5), columns = 1 + int(random() % 5);
    std::vector<PagePatch> patches = Sheet(rows, columns).patches();
    std::ranges::shuffle(patches, random);
    std::uniform_real_distribution<double> jitter(-0.3 * tolerance, 0.3 * tolerance);
    for (PagePatch& patch : patches) {
      patch = laid(patch, {0, int(random() % 4), random() % 2 == 0});
      for (glm::dvec2& point : patch.outer) point += glm::dvec2(jitter(random), jitter(random));
    }
    const PatchSides sides(patches, tolerance);
    const auto found = page_grids(sides);
    ASSERT_EQ(found.size(), 1U) << seed;
    const bool is_turned = found[0].rows != rows;
    EXPECT_EQ(found[0].rows, is_turned ? columns : rows);
    EXPECT_EQ(found[0].columns, is_turned ? rows : columns);
    expect_joined(found[0], sides);
    // None is a mirror image of what is seen: corners lie clockwise.
    for (const LaidPatch& lies : found[0].patches) {
      const PagePatch patch = laid(sides.patches()[std::size_t(lies.patch)], lies);
      const glm::dvec2 a = patch.outer[3] - patch.outer[0], b = patch.outer[9] - patch.outer[0];
      EXPECT_GT(a.x * b.y - a.y * b.x, 0);
    }
  }
}

TEST(PageGrids, AMirroredSheetKeepsItsRows) {
  std::vector<PagePatch> patches = Sheet(2, 4).patches();
  for (PagePatch& patch : patches) {
    for (glm::dvec2& point : patch.outer) point.x = -point.x;
    for (glm::dvec2& point : patch.inner) point.x = -point.x;
  }
  const auto found = grids(patches);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].rows, 2);
  EXPECT_EQ(numbers(found[0]), (std::vector<int>{3, 2, 1, 0, 7, 6, 5, 4}));
}

TEST(PageGrids, WhatIsNoRectangleBecomesSeveral) {
  const Sheet sheet(3, 3);
  std::vector<PagePatch> patches = sheet.patches();
  patches.pop_back();
  const auto found = grids(patches);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(numbers(found[0]), (std::vector<int>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(numbers(found[1]), (std::vector<int>{6, 7}));
}

TEST(PageGrids, ColoursThatDifferAreABorder) {
  std::vector<PagePatch> patches = Sheet(1, 3).patches();
  for (glm::dvec4& color : patches[2].colors) color.b = 0;
  EXPECT_EQ(grids(patches).size(), 2U);
}

TEST(PageGrids, AThirdPatchOnASideJoinsNothing) {
  const Sheet sheet(1, 2);
  std::vector<PagePatch> patches = sheet.patches();
  PagePatch third = sheet.patch(0, 1);
  for (std::size_t n = 4; n < 9; ++n) third.outer[n] += glm::dvec2(1, 1);
  patches.push_back(third);
  EXPECT_EQ(grids(patches).size(), 3U);
}

TEST(PageGrids, PatchesOverOneAnotherAreNotFoldedOut) {
  const PagePatch patch = Sheet(1, 1).patch(0, 0);
  EXPECT_EQ(grids({patch, patch}).size(), 2U);
}

TEST(PageGrids, ARingIsCutWhereItBegins) {
  // Four patches around a hole; the last one ends where the first one begins.
  std::vector<PagePatch> patches;
  for (int k = 0; k < 4; ++k) {
    const auto at = [&](double radius, double share) {
      const double angle = std::acos(-1) / 2 * (std::fmod(k + share, 4.0));
      return glm::dvec2(radius * std::cos(angle), radius * std::sin(angle));
    };
    PagePatch patch;
    for (std::size_t n = 0; n < 4; ++n) {
      patch.outer[n] = at(10, double(n) / 3);
      patch.outer[3 + n] = at(10 - double(n), 1);
      patch.outer[6 + n] = at(7, 1 - double(n) / 3);
      if (n > 0 && n < 3) patch.outer[9 + n] = at(7 + double(n), 0);
    }
    patches.push_back(patch);
  }
  const auto found = grids(patches);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].rows, 1);
  EXPECT_EQ(numbers(found[0]), (std::vector<int>{0, 1, 2, 3}));
}

TEST(PageGrids, TipsAreBorders) {
  // Both patches have a side that is the same point.
  std::vector<PagePatch> patches(2);
  for (int k = 0; k < 2; ++k) {
    PagePatch& patch = patches[std::size_t(k)];
    const double far = k ? -9 : 9;
    for (std::size_t n = 4; n < 9; ++n) patch.outer[n] = {far, double(n)};
    for (const std::size_t n : {9U, 10U, 11U}) patch.outer[n] = {far / 3, double(n)};
  }
  EXPECT_EQ(grids(patches).size(), 2U);
}

/// The half of a patch beside side 3 (`which` 0) or side 1, by de Casteljau's rule in each row.
ShadingPatch half_of(const ShadingPatch& patch, int which) {
  ShadingPatch half;
  auto net = patch.net();
  for (auto& row : net) {
    const glm::dvec2 a = 0.5 * (row[0] + row[1]), b = 0.5 * (row[1] + row[2]);
    const glm::dvec2 c = 0.5 * (row[2] + row[3]), d = 0.5 * (a + b), e = 0.5 * (b + c);
    const glm::dvec2 middle = 0.5 * (d + e);
    if (which == 0)
      row = {row[0], a, d, middle};
    else
      row = {middle, e, c, row[3]};
  }
  half.outer = {net[0][0], net[0][1], net[0][2], net[0][3], net[1][3], net[2][3],
                net[3][3], net[3][2], net[3][1], net[3][0], net[2][0], net[1][0]};
  half.inner = {net[1][1], net[1][2], net[2][2], net[2][1]};
  const auto between = [&](std::size_t a, std::size_t b) {
    return Components{(patch.colors[a][0] + patch.colors[b][0]) / 2};
  };
  half.colors = patch.colors;
  half.colors[which == 0 ? 1 : 0] = between(0, 1);
  half.colors[which == 0 ? 2 : 3] = between(3, 2);
  return half;
}

/// Halves a patch again and again and lists each half in any way, on 1/2048 of a point.
void add_halves(const ShadingPatch& patch, int levels, std::mt19937& random,
                std::vector<ShadingPatch>& halves) {
  const std::size_t turns = random() % 4;
  const bool is_mirrored = random() % 2 == 0;
  const ShadingPatch listed = is_mirrored ? patch.turned(turns).mirrored() : patch.turned(turns);
  if (levels == 0 || random() % 5 == 0) {
    halves.push_back(listed);
    for (glm::dvec2& point : halves.back().outer) point = glm::round(point * 2048.0) / 2048.0;
    for (glm::dvec2& point : halves.back().inner) point = glm::round(point * 2048.0) / 2048.0;
    return;
  }
  for (const int which : {0, 1}) add_halves(half_of(listed, which), levels - 1, random, halves);
}

ShadingPatch patch_of_sheet(int row, int column) {
  const PagePatch page = Sheet(2, 3).patch(row, column);
  ShadingPatch patch{page.outer, page.inner, {}};
  for (std::size_t k = 0; k < 4; ++k) patch.colors[k] = {page.colors[k].r + page.colors[k].g};
  return patch;
}

TEST(JoinedHalves, AreThePatchHoweverTheyAreListed) {
  const ShadingPatch whole = patch_of_sheet(0, 0);
  const ShadingPatch a = half_of(whole, 0), b = half_of(whole, 1);
  for (std::size_t n = 0; n < 4; ++n)
    for (const ShadingPatch& second : {b.turned(n), b.turned(n).mirrored()}) {
      const auto found = joined(a, second, 1e-9);
      ASSERT_TRUE(found);
      for (std::size_t i = 0; i < 12; ++i)
        EXPECT_LT(glm::distance(found->outer[i], whole.outer[i]), 1e-9);
      for (std::size_t k = 0; k < 4; ++k)
        EXPECT_LT(glm::distance(found->inner[k], whole.inner[k]), 1e-9);
      EXPECT_EQ(found->colors, whole.colors);
    }
}

TEST(JoinedHalves, OtherNeighboursAreNone) {
  EXPECT_FALSE(joined(patch_of_sheet(0, 0), patch_of_sheet(0, 1), 0.01));
  const ShadingPatch whole = patch_of_sheet(0, 0);
  ShadingPatch b = half_of(whole, 1);
  b.colors[0] = {0.9};
  EXPECT_FALSE(joined(half_of(whole, 0), b, 0.01));
}

/// Up to five levels, about as many as Illustrator has.
TEST(JoinedHalves, HalvingIsTakenBack) {
  for (unsigned seed = 0; seed < 30; ++seed) {
    std::mt19937 random(seed);
    std::vector<ShadingPatch> halves;
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 3; ++j) add_halves(patch_of_sheet(i, j), 5, random, halves);
    const auto wholes = without_halving(halves);
    ASSERT_EQ(wholes.size(), 6U) << seed;
    for (std::size_t n = 0; n < 6; ++n)
      for (std::size_t k = 0; k < 4; ++k) {
        const ShadingPatch wanted = patch_of_sheet(int(n) / 3, int(n) % 3);
        const bool is_there = std::ranges::any_of(wanted.outer, [&](glm::dvec2 point) {
          return glm::distance(point, wholes[n].outer[3 * k]) < 1e-3;
        });
        EXPECT_TRUE(is_there);
      }
  }
}

}  // namespace
}  // namespace gradmesh
