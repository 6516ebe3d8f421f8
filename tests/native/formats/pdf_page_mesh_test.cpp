#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <random>

#include "formats/pdf/grid/joined_curves.h"
#include "formats/pdf/grid/page_mesh.h"
#include "formats/pdf/grid/patch_sides.h"
#include "mesh/build.h"
#include "mesh/validate.h"
#include "page_sheets.h"

namespace gradmesh {
namespace {

constexpr double tolerance = 1e-3;

PagePatch in_any_way(const PagePatch& patch, std::mt19937& random) {
  const int first = int(random() % 4);
  return laid(patch, {0, first, random() % 2 == 0});
}

TEST(PageMesh, PatchesBesideALongerOneDivideItsSide) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    const double share = std::uniform_real_distribution<double>(0.1, 0.9)(random);
    const Sheet sheet(2, 2);
    std::vector<PagePatch> patches{sheet.patch(0, 0), sheet.patch(0, 1), sheet.patch(1, 1)};
    for (const PagePatch& part : divided(sheet.patch(1, 0), share)) patches.push_back(part);
    std::ranges::shuffle(patches, random);
    for (PagePatch& patch : patches) patch = laid(patch, {0, int(random() % 4), random() % 2 == 0});
    const MeshParts parts = page_mesh(patches, tolerance);
    // Between the upper two, the right two, the parts, a part and its neighbour, and the divided
    // one.
    ASSERT_EQ(parts.curves.size(), 5U) << seed;
    const auto long_one = std::ranges::find_if(
        parts.curves, [](const CurveParts& curve) { return curve.b.halfedges.size() == 2; });
    ASSERT_NE(long_one, parts.curves.end());
    // Against the direction of side 2 of the patch above, which runs to the left.
    EXPECT_NEAR(long_one->b.breaks.at(0), share, 1e-3);
    EXPECT_EQ(build_mesh(parts).face_count(), 5);
  }
}

TEST(PageMesh, ASheetIsJoinedAsAGridIs) {
  const MeshParts parts = page_mesh(Sheet(3, 4).patches(), tolerance);
  EXPECT_EQ(parts.curves.size(), grid_curves(3, 4).size());
  EXPECT_EQ(build_mesh(parts).face_count(), 12);
}

/// Returns how many sides no curve has.
int loose_sides(const MeshParts& parts) {
  int joined = 0;
  for (const CurveParts& curve : parts.curves)
    joined += int(curve.a.halfedges.size() + curve.b.halfedges.size());
  return 4 * int(parts.patches.size()) - joined;
}

void expect_sound(const MeshParts& parts, unsigned seed) {
  const Mesh mesh = build_mesh(parts);
  EXPECT_EQ(mesh.face_count(), int(parts.patches.size())) << seed;
  EXPECT_EQ(validate(mesh), std::vector<std::string>{}) << seed;
}

TEST(PageMesh, BothSidesOfACurveAreDividedAnywhere) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> share(0.15, 0.85);
    const Sheet sheet(2, 1);
    std::vector<PagePatch> patches;
    for (int row = 0; row < 2; ++row)
      for (const PagePatch& part : divided(sheet.patch(row, 0), share(random)))
        patches.push_back(in_any_way(part, random));
    const MeshParts parts = page_mesh(patches, tolerance);
    ASSERT_EQ(parts.curves.size(), 3U) << seed;
    EXPECT_EQ(parts.curves[2].a.halfedges.size(), 2U);
    EXPECT_EQ(parts.curves[2].b.halfedges.size(), 2U);
    expect_sound(parts, seed);
  }
}

/// Adds the parts of a patch, which is divided again and again, half of all times in halves.
void add_parts(const PagePatch& patch, int depth, std::mt19937& random,
               std::vector<PagePatch>& parts) {
  if (depth == 0 || random() % 4 == 0) {
    parts.push_back(in_any_way(patch, random));
    return;
  }
  const double share =
      random() % 2 == 0 ? 0.5 : std::uniform_real_distribution<double>(0.25, 0.75)(random);
  for (const PagePatch& part : divided(patch.turned(random() % 2), share))
    add_parts(part, depth - 1, random, parts);
}

std::vector<PagePatch> divided_sheet(int rows, int columns, int depth, std::mt19937& random) {
  std::vector<PagePatch> patches;
  for (const PagePatch& patch : Sheet(rows, columns).patches())
    add_parts(patch, depth, random, patches);
  std::ranges::shuffle(patches, random);
  return patches;
}

/// Returns whether a side lies along the outline of the sheet: its middle is the place of one
/// there.
bool is_on_outline(const PagePatch& patch, std::size_t side, int rows, int columns) {
  const Sheet sheet(rows, columns);
  const ControlRow curve{patch.side_point(side, 0), patch.side_point(side, 1),
                         patch.side_point(side, 2), patch.side_point(side, 3)};
  const glm::dvec2 middle = cubic_of(curve).at(0.5);
  const auto is_beside = [&](int row, int column, std::size_t k) {
    const PagePatch whole = sheet.patch(row, column);
    const ControlRow line{whole.side_point(k, 0), whole.side_point(k, 1), whole.side_point(k, 2),
                          whole.side_point(k, 3)};
    return glm::distance(cubic_of(line).at(nearest_on(line, middle)), middle) < 1e-6;
  };
  for (int row = 0; row < rows; ++row)
    if (is_beside(row, 0, 3) || is_beside(row, columns - 1, 1)) return true;
  for (int column = 0; column < columns; ++column)
    if (is_beside(0, column, 0) || is_beside(rows - 1, column, 2)) return true;
  return false;
}

TEST(PageMesh, DividedSheetsAreJoinedAllOver) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    std::mt19937 random(seed);
    const int rows = 1 + int(random() % 3), columns = 1 + int(random() % 3);
    const auto patches = divided_sheet(rows, columns, 4, random);
    const MeshParts parts = page_mesh(patches, tolerance);
    // Sides that lie along the outline.
    int outline = 0;
    for (const PagePatch& patch : patches)
      for (std::size_t k = 0; k < 4; ++k) outline += is_on_outline(patch, k, rows, columns);
    EXPECT_EQ(loose_sides(parts), outline) << seed;
    expect_sound(parts, seed);
  }
}

TEST(PageMesh, RoundedPatchesMakeAMeshWhateverIsJoined) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    std::mt19937 random(seed);
    auto patches = divided_sheet(1 + int(random() % 4), 1 + int(random() % 4), 5, random);
    const double most = std::uniform_real_distribution<double>(0.1, 3)(random) * tolerance;
    std::uniform_real_distribution<double> noise(-most, most);
    for (PagePatch& patch : patches)
      for (glm::dvec2& point : patch.outer) point += glm::dvec2(noise(random), noise(random));
    expect_sound(page_mesh(patches, tolerance), seed);
  }
}

TEST(PageMesh, CurvesThatHangOnEachOtherAreLeftApart) {
  // Four around one, each of which ends on the next: without one of these curves there is none from
  // the T-junction on the next.
  const std::vector<PagePatch> patches{
      rectangular_patch({0, 0}, {2, 1}), rectangular_patch({2, 0}, {3, 2}),
      rectangular_patch({1, 2}, {3, 3}), rectangular_patch({0, 1}, {1, 3}),
      rectangular_patch({1, 1}, {2, 2})};
  const MeshParts parts = page_mesh(patches, tolerance);
  EXPECT_EQ(loose_sides(parts), 20);
  expect_sound(parts, 0);
}

/// Rectangles between few points lie over each other in any way.
TEST(PageMesh, AnyPatchesMakeAMesh) {
  for (unsigned seed = 0; seed < 3000; ++seed) {
    std::mt19937 random(seed);
    const int lines = 3 + int(random() % 3);
    std::vector<PagePatch> patches;
    for (int n = 2 + int(random() % 14); n > 0; --n) {
      const auto place = [&] {
        return glm::dvec2(double(random() % unsigned(lines)), double(random() % unsigned(lines)));
      };
      const glm::dvec2 from = place(), to = place();
      patches.push_back(in_any_way(rectangular_patch(from, to), random));
    }
    expect_sound(page_mesh(patches, tolerance), seed);
  }
}

}  // namespace
}  // namespace gradmesh
