// Meshes that Illustrator keeps for itself beside a page.
#include <gtest/gtest.h>

#include "formats/pdf/records/mesh_records.h"
#include "formats/pdf/records/record_of_page.h"

namespace gradmesh {
namespace {

constexpr const char* right_patch =
    "%_[1 0] /P X#\r%_[0.5] /R X#\r"
    "%_[0 0 0 1 1 90 -90 120 -90 1 90 -60 1] /N X#\r"
    "%_[0 0 0 1 1 180 -90 180 -60 1 150 -90 1] /N X#\r"
    "%_[0 0 0 1 1 180 0 150 0 1 180 -30 1] /N X#\r"
    "%_[0 0 0 1 1 90 0 90 -30 1 120 0 1] /N X#\r%_/E X#\r";

/// A record of two patches beside one another, the left one with what is given before its first
/// node, which may be anchors.
std::string record(const std::string& anchors = "", const std::string& right = right_patch) {
  return "%_1 w\r/Mesh X!\r%_2 /Version X#\r%_/Cartesian /Type X#\r%_[2 1] /Size X#\r%_/Data X#\r"
         "%_[0 0] /P X#\r%_[0] /R X#\r%_/DeviceCMYK /CS X#\r" +
         anchors +
         "%_[0 0 0 1 1 0 -90 30 -95 1 0 -60 1] /N X#\r"
         "%_[0 0 0 1 1 90 -90 90 -60 1 60 -85 1] /N X#\r"
         // Of a list of inks, over several lines.
         "%_[ [0 0 1 0 /DeviceCMYK (Yellow) /Separation]\r"
         "%_[0 1 0 0 /DeviceCMYK (Magenta) /Separation]\r%_2 /NChannel] /CS X#\r"
         "%_[0.25 0.5 1 90 0 60 5 1 90 -30 1] /N X#\r%_/DeviceCMYK /CS X#\r"
         "%_[0 0 0 1 1 0 0 0 -30 1 30 5 1] /N X#\r%_/E X#\r" +
         right + "/End X!\r";
}

TEST(MeshRecords, AreGridsWithRowsFromAbove) {
  const auto grids = read_mesh_records(record());
  ASSERT_EQ(grids.size(), 1U);
  EXPECT_EQ(std::pair(grids[0].rows, grids[0].columns), std::pair(1, 2));
  EXPECT_TRUE(grids[0].smooth);
  const PagePatch& left = grids[0].patches[0];
  // Clockwise from the upper left, y down.
  const std::array<glm::dvec2, 12> outer{{{0, 0},
                                          {30, -5},
                                          {60, -5},
                                          {90, 0},
                                          {90, 30},
                                          {90, 60},
                                          {90, 90},
                                          {60, 85},
                                          {30, 95},
                                          {0, 90},
                                          {0, 60},
                                          {0, 30}}};
  EXPECT_EQ(left.outer, outer);
  EXPECT_EQ(left.inner[0], glm::dvec2(30, 25));
  const PagePatch& right = grids[0].patches[1];
  for (std::size_t n = 0; n < 4; ++n)
    EXPECT_EQ(right.side_point(3, n), left.side_point(1, 3 - n)) << n;
}

TEST(MeshRecords, SidesWithAnchorsAreTheClosestCurve) {
  // In the middle of a straight side, as if that were halved.
  const auto grids = read_mesh_records(record("%_[0 -45 0 -60 0 -30 1] /A X#\r"));
  ASSERT_EQ(grids.size(), 1U);
  const PagePatch& patch = grids[0].patches[0];
  for (std::size_t n = 0; n < 4; ++n) EXPECT_NEAR(patch.side_point(3, n).x, 0, 1e-9);
  EXPECT_EQ(patch.side_point(3, 0), glm::dvec2(0, 90));
  EXPECT_EQ(patch.side_point(3, 3), glm::dvec2(0, 0));
}

TEST(MeshRecords, BrokenOnesAreLeftOut) {
  const std::string right = right_patch;
  const auto without = [&](const std::string& words) {
    std::string text = right;
    return text.erase(text.find(words), words.size());
  };
  const auto with = [&](const std::string& words, const std::string& others) {
    std::string text = right;
    return text.replace(text.find(words), words.size(), others);
  };
  const std::string node = "%_[0 0 0 1 1 180 0 150 0 1 180 -30 1] /N X#\r";
  for (const std::string& broken :
       {std::string(), without(node), with("[1 0]", "[0 0]"), with("[1 0]", "[2 0]"),
        with("180 0 150", "180 x 150"), with("180 0 150", "1e9 0 150"),
        with("180 0 150", "nan 0 1"), right + right, right + node}) {
    const auto grids = read_mesh_records(record("", broken) + record());
    EXPECT_EQ(grids.size(), 1U) << broken;
  }
  EXPECT_TRUE(read_mesh_records(record().substr(0, 500)).empty());
  EXPECT_TRUE(read_mesh_records("").empty());
}

/// The left patch of the record in two halves and the right one, moved.
std::vector<PagePatch> page_of(const ArtistsGrid& grid, glm::dvec2 by) {
  std::vector<PagePatch> page = grid.patches;
  for (PagePatch& patch : page) {
    for (glm::dvec2& point : patch.outer) point += by;
    for (std::size_t k = 0; k < 4; ++k)
      patch.colors[k] = {patch.outer[3 * k].x / 1000, 0.5, 0.25, 1};
  }
  return page;
}

TEST(RecordOfPage, LiesWhereThePageHasIt) {
  const ArtistsGrid grid = read_mesh_records(record()).at(0);
  for (const glm::dvec2 by : {glm::dvec2(0, 0), glm::dvec2(100, 37.25)}) {
    const std::vector<PagePatch> page = page_of(grid, by);
    const auto found = record_of_page(grid, page, PageColors(page));
    ASSERT_TRUE(found);
    EXPECT_EQ(found->patches[1].outer, page[1].outer);
    for (std::size_t k = 0; k < 4; ++k)
      EXPECT_NEAR(found->patches[1].colors[k].r, page[1].colors[k].r, 1e-6);
  }
}

TEST(RecordOfPage, IsNoneOfWhatThePageDoesNotShow) {
  const ArtistsGrid grid = read_mesh_records(record()).at(0);
  std::vector<PagePatch> page = page_of(grid, {5, 5});
  // One corner elsewhere.
  page[1].outer[3] += glm::dvec2(0, 1);
  EXPECT_FALSE(record_of_page(grid, page, PageColors(page)));
  // More than the record has.
  page = page_of(grid, {5, 5});
  page.push_back(page_of(grid, {300, 5})[0]);
  EXPECT_FALSE(record_of_page(grid, page, PageColors(page)));
}

}  // namespace
}  // namespace gradmesh
