// Surfaces that a page paints as hundreds of tiles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/common.hpp>

#include "app/document/svg_document.h"
#include "app/pages/page_documents.h"
#include "app/pages/read_document.h"
#include "mesh/boundary.h"
#include "pdf_shadings.h"

using namespace gradmesh;

namespace {

/// Where a surface has point (i, j) of its lattice, in points of the page.
using Place = std::function<glm::dvec2(int, int)>;

glm::dvec2 wave(int i, int j) { return {10 + 9 * j, 20 + 8 * i + 3 * std::sin(0.4 * j)}; }

struct Tile {
  std::array<glm::dvec2, 4> corners;
  std::array<int, 4> levels;
};

/// The tiles of a surface, row by row. Its colours blend bilinearly, and so are those of two
/// triangles only nearly.
std::vector<Tile> tiles_of(int rows, int columns, const Place& place) {
  std::vector<Tile> tiles;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      Tile& tile = tiles.emplace_back();
      static constexpr int around[4][2] = {{0, 0}, {0, 1}, {1, 1}, {1, 0}};
      for (std::size_t k = 0; k < 4; ++k) {
        const int row = i + around[k][0], column = j + around[k][1];
        tile.corners[k] = place(row, column);
        tile.levels[k] = 40 + 9 * row + 4 * column;
      }
    }
  return tiles;
}

/// A shading of type 4: the two triangles of a tile. Coordinates are in 1/65536 of 512 points.
std::string triangles(const Tile& tile) {
  BitWriter data;
  for (const std::size_t corner : {0, 1, 2, 0, 2, 3}) {
    data.add(0, 8);
    for (const double at : {tile.corners[corner].x, tile.corners[corner].y})
      data.add(std::uint32_t(std::lround(at * 128)), 16);
    const std::uint32_t level = std::uint32_t(tile.levels[corner]);
    data.add({level, 255 - level, 128}, 8);
  }
  return pdf_stream(
      "/ShadingType 4 /ColorSpace /DeviceRGB /BitsPerCoordinate 16 /BitsPerComponent 8 "
      "/BitsPerFlag 8 /Decode [0 511.9921875 0 511.9921875 0 1 0 1 0 1]",
      data.bytes());
}

std::string point(glm::dvec2 at) { return std::to_string(at.x) + " " + std::to_string(at.y) + " "; }

/// What a content paints a tile with: its name, and a path around it.
using PaintTile = std::function<std::string(const std::string& name, const Tile& tile)>;

std::string with_path_around(const std::string& name, const Tile& tile) {
  const auto& [a, b, c, d] = tile.corners;
  return "q " + point(a) + "m " + point(b) + "l " + point(c) + "l " + point(d) + "l h W n " + name +
         " sh Q ";
}
std::string alone(const std::string& name, const Tile&) { return name + " sh "; }

std::unique_ptr<Document> read(const std::vector<Tile>& tiles, const PaintTile& paint,
                               const std::string& before = "", const std::string& behind = "") {
  std::string shadings, content = before;
  std::vector<std::string> objects;
  for (const Tile& tile : tiles) {
    const std::string name = "/t" + std::to_string(objects.size());
    shadings += name + " " + std::to_string(5 + objects.size()) + " 0 R ";
    objects.push_back(triangles(tile));
    content += paint(name, tile);
  }
  const std::string entries = "/MediaBox [0 0 300 300] /Resources << /Shading << " + shadings +
                              ">> /ExtGState << /half << /ca 0.5 >> >> >>";
  return parse_document(pdf_document(entries, content + behind, objects), "a.pdf", {});
}

TEST(PageTiles, are_one_mesh) {
  const auto document = read(tiles_of(4, 6, wave), with_path_around, "", "5 0 0 5 0 0 cm /t0 sh");
  const std::vector<FoundMesh>& found = document->pages()->meshes;
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].id, "page-1-mesh-1");
  EXPECT_EQ(std::tuple(found[0].shadings, found[0].patches), std::tuple(24, 48));
  // Which of its directions are rows is for the corner that is listed first.
  EXPECT_EQ(std::min(found[0].rows, found[0].columns), 4);
  EXPECT_EQ(std::max(found[0].rows, found[0].columns), 6);
  EXPECT_TRUE(found[0].is_joined);
  EXPECT_LT(found[0].difference, 0.01);
  EXPECT_EQ(std::tuple(found[1].id, found[1].shadings), std::tuple("page-1-mesh-25", 1));
  EXPECT_TRUE(document->pages()->left_out.empty());
  // Nothing but the mesh's own outline is seen.
  EXPECT_EQ(document->bytes().find("clip-path"), std::string::npos);
}

TEST(PageTiles, keep_the_clip_path_around_all_of_them) {
  const std::string around = "30 30 m 50 30 l 40 60 l h W n ";
  for (const PaintTile& paint : {PaintTile(alone), PaintTile(with_path_around)}) {
    const auto document = read(tiles_of(4, 6, wave), paint, around);
    ASSERT_EQ(document->meshes().size(), 1U);
    const auto area = document->visible_area(document->meshes()[0]);
    ASSERT_TRUE(area);
    const glm::dvec2 size = bounding_box(area->sets.at(0).at(0).outline).size();
    EXPECT_NEAR(size.x, 20 * 96 / 72.0, 1e-6);
    EXPECT_NEAR(size.y, 30 * 96 / 72.0, 1e-6);
  }
}

TEST(PageTiles, are_painted_alike) {
  int count = 0;
  const auto document = read(tiles_of(4, 6, wave), [&](const std::string& name, const Tile& tile) {
    return (++count == 13 ? "/half gs " : "") + alone(name, tile);
  });
  std::vector<int> shadings;
  for (const FoundMesh& found : document->pages()->meshes) shadings.push_back(found.shadings);
  EXPECT_EQ(shadings, (std::vector<int>{12, 12}));
}

TEST(PageTiles, are_not_cut_by_their_paths) {
  const auto document = read(tiles_of(3, 3, wave), [](const std::string& name, const Tile& tile) {
    const auto& [a, b, c, d] = tile.corners;
    return "q " + point(a) + "m " + point(b) + "l " + point(c) + "l h W n " + name + " sh Q ";
  });
  EXPECT_EQ(document->meshes().size(), 9U);
}

TEST(PageTiles, tell_where_they_are_no_surface) {
  std::vector<Tile> tiles = tiles_of(8, 8, [](int i, int j) { return glm::dvec2(12 * j, 12 * i); });
  // They meet in every second corner alone.
  for (Tile& tile : tiles) {
    tile.corners[1] = glm::mix(tile.corners[1], tile.corners[0], 0.2);
    tile.corners[3] = glm::mix(tile.corners[3], tile.corners[2], 0.2);
  }
  const auto document = read(tiles, with_path_around);
  EXPECT_EQ(document->meshes().size(), 64U);
  ASSERT_EQ(document->pages()->left_out.size(), 1U);
  EXPECT_EQ(document->pages()->left_out[0].english(),
            "a.pdf, page 1, meshes 1 to 64: they join to no one surface that looks the same, so "
            "they are 64 meshes.");
}

// The rows come back over those before, as behind the top of a hill.
TEST(PageTiles, are_few_meshes_where_the_surface_folds) {
  const auto fold = [](int i, int j) {
    return glm::dvec2(10 + 9 * j + 0.7 * i, 100 + 40 * std::sin(0.35 * i) + 2 * std::cos(j));
  };
  const auto document = read(tiles_of(10, 8, fold), with_path_around);
  int shadings = 0;
  for (const FoundMesh& found : document->pages()->meshes) {
    shadings += found.shadings;
    EXPECT_LT(found.difference, 0.01);
  }
  EXPECT_EQ(shadings, 80);
  EXPECT_LE(document->meshes().size(), 20U);
}

}  // namespace
