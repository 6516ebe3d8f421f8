#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "form/smooth_colors.h"
#include "formats/pdf/grid/smooth_grid.h"
#include "mesh/build.h"
#include "page_sheets.h"

namespace gradmesh {
namespace {

constexpr int rows = 2, columns = 3;

/// Colours that turn and that are limited where they pass white.
glm::dvec4 color_at(int i, int j) {
  return {0.5 + 0.5 * std::sin(2.0 * i + j), i == 1 ? 1.0 : 0.4, 0.3 * j, 0.5 + 0.1 * i};
}

std::vector<PagePatch> artists_patches() {
  std::vector<PagePatch> patches = Sheet(rows, columns).patches();
  for (std::size_t n = 0; n < patches.size(); ++n)
    for (std::size_t k = 0; k < 4; ++k)
      patches[n].colors[k] =
          color_at(int(n) / columns + (k > 1), int(n) % columns + (k == 1 || k == 2));
  return patches;
}

/// Returns the sheet as Inkscape writes it, with 8 x 8 for each patch; unless it is `smooth`, with
/// colours that Inkscape never divides.
ArtistsGrid painted(bool smooth = true) {
  MeshParts parts{{}, grid_curves(rows, columns)};
  parts.smooth = smooth;
  for (const PagePatch& patch : artists_patches()) parts.patches.push_back(mesh_patch(patch));
  ArtistsGrid grid{8 * rows, 8 * columns, {}};
  const Mesh mesh = build_mesh(parts), fine = painted_mesh(mesh);
  for (const Face face : fine.faces()) {
    const BezierNet net = bezier_net(fine.patch(face));
    PagePatch& page = grid.patches.emplace_back();
    std::array<std::array<glm::dvec2, 4>, 4> points{};
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 4; ++j) points[i][j] = glm::round(net[i][j].position * 1e7) / 1e7;
    page.set_net(points);
    page.colors = {net[0][0].color, net[0][3].color, net[3][3].color, net[3][0].color};
    for (glm::dvec4& color : page.colors) color = glm::round(color * 255.0) / 255.0;
  }
  if (smooth) return grid;
  // Bilinear within the whole patch.
  for (std::size_t n = 0; n < grid.patches.size(); ++n)
    for (std::size_t k = 0; k < 4; ++k) {
      const int row = int(n) / (8 * columns), column = int(n) % (8 * columns);
      const Patch& whole = parts.patches[std::size_t(row / 8 * columns + column / 8)];
      grid.patches[n].colors[k] =
          whole.at((row % 8 + (k > 1)) / 8.0, (column % 8 + (k == 1 || k == 2)) / 8.0).color;
    }
  return grid;
}

TEST(SmoothGrid, IsTheArtistsAgain) {
  const auto found = smooth_grid(painted());
  ASSERT_TRUE(found);
  EXPECT_EQ(found->rows, rows);
  EXPECT_EQ(found->columns, columns);
  EXPECT_TRUE(found->smooth);
  const std::vector<PagePatch> wanted = artists_patches();
  ASSERT_EQ(found->patches.size(), wanted.size());
  for (std::size_t n = 0; n < wanted.size(); ++n) {
    for (std::size_t i = 0; i < PagePatch::outer_count; ++i)
      EXPECT_LT(glm::distance(found->patches[n].outer[i], wanted[n].outer[i]), 1e-6);
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_LT(glm::distance(found->patches[n].inner[k], wanted[n].inner[k]), 1e-6);
      EXPECT_LE(glm::distance(found->patches[n].colors[k], wanted[n].colors[k]), 1.0 / 255);
    }
  }
}

TEST(SmoothGrid, NeedsEightPartsEachWay) {
  ArtistsGrid grid = painted();
  grid.patches.resize(grid.patches.size() - std::size_t(grid.columns));
  --grid.rows;
  EXPECT_FALSE(smooth_grid(grid));
}

TEST(SmoothGrid, OtherColoursAreNotSmooth) {
  EXPECT_FALSE(smooth_grid(painted(false)));
  ArtistsGrid grid = painted();
  grid.patches[77].colors[2].b += 2.5 / 255;
  EXPECT_FALSE(smooth_grid(grid));
}

TEST(SmoothGrid, PartsOfNoPatchAreNotJoined) {
  ArtistsGrid grid = painted();
  grid.patches[77].outer[4].x += 0.02;
  EXPECT_FALSE(smooth_grid(grid));
  grid = painted();
  grid.patches[77].inner[1].y += 0.02;
  EXPECT_FALSE(smooth_grid(grid));
}

}  // namespace
}  // namespace gradmesh
