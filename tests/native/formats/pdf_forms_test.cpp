// Meshes that may stand for the patches of a page: grids with more lines where colours need them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "formats/pdf/grid/mesh_forms.h"
#include "formats/pdf/grid/page_colors.h"
#include "formats/pdf/grid/paired_triangles.h"
#include "formats/pdf/grid/refined_grid.h"

namespace gradmesh {
namespace {

constexpr double side = 100;

/// A rectangle with straight sides whose corners have the colours of a function of the page.
template <class ColorAt>
PagePatch rectangle(glm::dvec2 low, glm::dvec2 high, const ColorAt& color_at) {
  const std::array<glm::dvec2, 4> corners{low, {high.x, low.y}, high, {low.x, high.y}};
  const auto at = [&](double u, double v) { return low + glm::dvec2(v, u) * (high - low); };
  PagePatch patch;
  for (std::size_t k = 0; k < 4; ++k) {
    for (std::size_t n = 0; n < 3; ++n)
      patch.outer[3 * k + n] = corners[k] + double(n) / 3 * (corners[(k + 1) % 4] - corners[k]);
    patch.colors[k] = color_at(corners[k]);
  }
  patch.inner = {at(1.0 / 3, 1.0 / 3), at(1.0 / 3, 2.0 / 3), at(2.0 / 3, 2.0 / 3),
                 at(2.0 / 3, 1.0 / 3)};
  return patch;
}

/// A square page in strips from left to right, finer than what is to be seen.
template <class ColorAt>
std::vector<PagePatch> strips(int count, const ColorAt& color_at) {
  std::vector<PagePatch> all;
  for (int n = 0; n < count; ++n)
    all.push_back(rectangle({side * n / count, 0}, {side * (n + 1) / count, side}, color_at));
  return all;
}

glm::dvec4 curved(glm::dvec2 place) {
  const double x = place.x / side;
  return {x * x * x, 1 - x * x, 0.5, 1};
}

TEST(PageColors, AreThoseOfThePatchThatIsThere) {
  const PageColors page(strips(4, curved));
  const glm::dvec4 between = 0.5 * (curved({25, 0}) + curved({50, 0}));
  for (const double y : {0.0, 30.0, 100.0})
    for (int c = 0; c < 4; ++c) EXPECT_NEAR(page.at({37.5, y})[c], between[c], 1e-6);
}

TEST(PageColors, AreTheNearestOnesBesideThePatches) {
  const PageColors page(strips(4, curved));
  for (int c = 0; c < 4; ++c)
    EXPECT_NEAR(page.at({50, side + 0.3})[c], curved({50, side})[c], 1e-3);
}

PatchGrid one_patch() { return {1, 1, {mesh_patch(rectangle({0, 0}, {side, side}, curved))}}; }

TEST(RefinedGrid, IsDividedWhereColoursNeedIt) {
  const PageColors page(strips(64, curved));
  RefinedGrid grid(one_patch(), page);
  ASSERT_TRUE(grid.divide());
  ASSERT_TRUE(grid.divide());
  EXPECT_EQ(grid.rows(), 1);
  EXPECT_EQ(grid.columns(), 3);
  const PatchGrid refined = grid.grid();
  ASSERT_EQ(refined.patches.size(), 3U);
  for (const Patch& patch : refined.patches)
    for (int k = 0; k < 4; ++k) {
      const Value corner = patch.corner(k);
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(corner.color[c], curved(corner.position)[c], 0.51 / 255);
    }
  // Parts of the artist's patch, next to one another.
  EXPECT_EQ(refined.patches[0].corner(1), refined.patches[1].corner(0));
  EXPECT_EQ(refined.patches[2].corner(1).position, glm::dvec2(side, 0));
}

TEST(RefinedGrid, IsNotDividedWhereItLooksLikeThePage) {
  const auto even = [](glm::dvec2 place) { return glm::dvec4(place.x / side, 0, 0, 1); };
  const PageColors page(strips(8, even));
  PatchGrid two{1, 2, {}};
  for (const PagePatch& patch : strips(2, even)) two.patches.push_back(mesh_patch(patch));
  RefinedGrid grid(two, page);
  EXPECT_FALSE(grid.divide());
}

/// Shadings' patches with components in RGB.
std::vector<ShadingPatch> in_components(const std::vector<PagePatch>& patches) {
  std::vector<ShadingPatch> all;
  for (const PagePatch& page : patches) {
    ShadingPatch& patch = all.emplace_back();
    patch.outer = page.outer;
    patch.inner = page.inner;
    for (std::size_t k = 0; k < 4; ++k)
      patch.colors[k] = {page.colors[k].r, page.colors[k].g, page.colors[k].b};
  }
  return all;
}

std::vector<PagePatch> in_rgb(const std::vector<ShadingPatch>& patches) {
  std::vector<PagePatch> all;
  for (const ShadingPatch& patch : patches) {
    PagePatch& page = all.emplace_back();
    page.outer = patch.outer;
    page.inner = patch.inner;
    for (std::size_t k = 0; k < 4; ++k)
      page.colors[k] = {patch.colors[k][0], patch.colors[k][1], patch.colors[k][2], 1};
  }
  return all;
}

std::vector<MeshForm> forms(const std::vector<PagePatch>& patches) {
  MeshForms all(in_components(patches), patches, in_rgb);
  std::vector<MeshForm> found;
  while (std::optional<MeshForm> form = all.next()) found.push_back(std::move(*form));
  EXPECT_EQ(found.back().mesh.patches.size(), all.page().mesh.patches.size());
  return found;
}

TEST(MeshForms, AGridIsLeftAsItIs) {
  const std::vector<MeshForm> found = forms(strips(8, curved));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].kind, MeshForm::Kind::page);
  EXPECT_EQ(found[0].mesh.patches.size(), 8U);
  EXPECT_FALSE(found[0].mesh.smooth);
}

TEST(MeshForms, HalvesBecomeTheArtistsGridAndThenFinerOnes) {
  // An artist's two patches, the left one halved twice, the lower half of that again.
  std::vector<PagePatch> page;
  const auto add = [&](double left, double top, double right, double bottom) {
    page.push_back(rectangle({left, top}, {right, bottom}, curved));
  };
  add(0, 0, 25, 50);
  add(25, 0, 50, 50);
  add(0, 50, 50, 75);
  add(0, 75, 50, 100);
  add(50, 0, 90, 100);
  add(90, 0, 130, 100);
  const std::vector<MeshForm> found = forms(page);
  ASSERT_GE(found.size(), 3U);
  EXPECT_EQ(found[0].kind, MeshForm::Kind::artists);
  EXPECT_TRUE(found[0].mesh.smooth);
  EXPECT_EQ(found[0].mesh.patches.size(), 2U);
  EXPECT_EQ(found[1].kind, MeshForm::Kind::joined);
  EXPECT_FALSE(found[1].mesh.smooth);
  EXPECT_EQ(found[1].mesh.patches.size(), 2U);
  for (std::size_t n = 2; n + 1 < found.size(); ++n) {
    EXPECT_EQ(found[n].kind, MeshForm::Kind::artists);
    EXPECT_GT(found[n].mesh.patches.size(), found[0].mesh.patches.size());
    EXPECT_LT(found[n].mesh.patches.size(), page.size());
  }
  EXPECT_EQ(found.back().kind, MeshForm::Kind::page);
  EXPECT_EQ(found.back().mesh.patches.size(), page.size());
}

/// A triangle as a patch with a tip.
ShadingPatch triangle(const std::array<glm::dvec2, 3>& places) {
  const std::array<glm::dvec2, 4> corners{places[0], places[1], places[2], places[2]};
  ShadingPatch patch;
  for (std::size_t k = 0; k < 4; ++k) {
    for (std::size_t n = 0; n < 3; ++n)
      patch.outer[3 * k + n] = corners[k] + double(n) / 3 * (corners[(k + 1) % 4] - corners[k]);
    patch.colors[k] = {corners[k].x / 100, corners[k].y / 100, 0};
  }
  return patch;
}

TEST(PairedTriangles, AreOnePatchWhereTheyFollowOneAnother) {
  const std::array<glm::dvec2, 4> corners{{{0, 0}, {50, 5}, {60, 60}, {-5, 50}}};
  // However each of the two is listed.
  for (std::size_t k = 0; k < 3; ++k)
    for (const bool is_reversed : {false, true}) {
      std::array<glm::dvec2, 3> first{corners[0], corners[1], corners[3]};
      std::rotate(first.begin(), first.begin() + std::ptrdiff_t(k), first.end());
      if (is_reversed) std::swap(first[1], first[2]);
      const auto pairs =
          paired_triangles({triangle(first), triangle({corners[1], corners[2], corners[3]})});
      ASSERT_EQ(pairs.size(), 1U);
      std::vector<glm::dvec2> found;
      for (std::size_t n = 0; n < 4; ++n) {
        found.push_back(pairs[0].outer[3 * n]);
        EXPECT_EQ(pairs[0].colors[n][0], found.back().x / 100);
      }
      EXPECT_EQ(found.front(), corners[0]);
      EXPECT_EQ(found[2], corners[2]);
    }
}

TEST(PairedTriangles, AreLeftAloneElsewhere) {
  const ShadingPatch one = triangle({{{0, 0}, {50, 0}, {0, 50}}});
  // Beside nothing, folded over one another, and one that would not be convex.
  EXPECT_EQ(paired_triangles({one, triangle({{{50, 0}, {90, 9}, {50, 50}}})}).size(), 2U);
  EXPECT_EQ(paired_triangles({one, triangle({{{50, 0}, {0, 50}, {-30, -30}}})}).size(), 2U);
  EXPECT_EQ(paired_triangles({one, triangle({{{50, 0}, {0, 50}, {90, -30}}})}).size(), 2U);
}

}  // namespace
}  // namespace gradmesh
