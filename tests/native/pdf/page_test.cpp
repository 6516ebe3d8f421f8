#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.h"
#include "formats/pdf/grid/joined_halves.h"
#include "formats/pdf/grid/page_grids.h"
#include "formats/pdf/grid/page_mesh.h"
#include "formats/pdf/grid/smooth_grid.h"
#include "formats/pdf/grid/without_anchors.h"
#include "formats/pdf/page/patch_colors.h"
#include "formats/pdf/page/pdf_file.h"
#include "formats/pdf/page/read_shading.h"
#include "mesh/build.h"
#include "pdf_documents.h"
#include "pdf_shadings.h"
#include "shading_bits.h"

namespace gradmesh {
namespace {

constexpr const char* page_entries =
    "/MediaBox [10 20 110 220] /Resources << /Shading << /sh 5 0 R >> /Pattern << /p 6 0 R >> "
    "/XObject << /x 7 0 R >> /ExtGState << /half << /ca 0.5 >> /masked << /SMask << /S "
    "/Luminosity /G 8 0 R >> >> /plain << /SMask /None >> >> >>";

std::vector<std::string> objects(const std::string& form = "/sh sh") {
  return {square_shading(), "<< /PatternType 2 /Shading 5 0 R /Matrix [2 0 0 2 0 0] >>",
          pdf_stream("/Type /XObject /Subtype /Form /BBox [0 0 50 50] /Matrix [1 0 0 1 5 0] "
                     "/Group << /S /Transparency >>",
                     form),
          pdf_stream("/Type /XObject /Subtype /Form /BBox [0 0 50 50]", "/sh sh")};
}

PageContent page_of(const std::string& document, const std::string& password = "") {
  const PdfFile file(document, "a.pdf", password);
  EXPECT_EQ(file.page_count(), 1U);
  return file.page(0);
}

PageContent painted_by(const std::string& content, const std::string& form = "/sh sh") {
  return page_of(pdf_document(page_entries, content, objects(form)));
}

/// The first corner of the shading's patch, and the one across, on the page.
std::pair<glm::dvec2, glm::dvec2> corners(const PaintedShading& painted) {
  const PageShading read = read_shading(painted);
  EXPECT_EQ(read.patches.size(), 1U);
  return {read.patches.at(0).outer[0], read.patches.at(0).outer[6]};
}

TEST(PdfPage, IsAsLargeAsItsBoxAndRunsDown) {
  const PageContent page = page_of(pdf_document(page_entries, "/sh sh", objects()));
  EXPECT_EQ(page.size, glm::dvec2(100, 200));
  ASSERT_EQ(page.painted.size(), 1U);
  const auto [first, across] = corners(page.painted[0]);
  EXPECT_EQ(first, glm::dvec2(-10, 220));
  EXPECT_EQ(across, glm::dvec2(-1, 211));
}

TEST(PdfPage, IsTurnedAndEnlarged) {
  const std::string entries = std::string(page_entries) + " /Rotate 90 /UserUnit 2";
  const PageContent page = page_of(pdf_document(entries, "/sh sh", objects()));
  EXPECT_EQ(page.size, glm::dvec2(400, 200));
  // What is at the lower left comes to the upper left.
  EXPECT_EQ(corners(page.painted.at(0)).first, glm::dvec2(-40, -20));
}

TEST(PdfPage, ShadingsLieInTheCurrentSpaceAndPatternsInThatOfThePage) {
  const PageContent page =
      painted_by("q 3 0 0 3 0 0 cm /sh sh Q /Pattern cs /p scn 3 0 0 3 0 0 cm 0 0 9 9 re f");
  const auto& found = page.painted;
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(corners(found[0]).second, glm::dvec2(17, 193));
  EXPECT_EQ(corners(found[1]).second, glm::dvec2(8, 202));
  EXPECT_TRUE(found[0].clips.empty());
  // The filled path is what a pattern is seen through.
  ASSERT_EQ(found[1].clips.size(), 1U);
  const auto& steps = found[1].clips[0]->steps;
  ASSERT_EQ(steps.size(), 5U);
  EXPECT_EQ(steps[2].points[2], glm::dvec2(17, 193));
}

TEST(PdfPage, ClipsHoldUntilTheStateIsRestored) {
  const PageContent page =
      painted_by("q 0 0 5 5 re W n /sh sh q 1 1 m 2 2 3 3 4 4 c h W* n /sh sh Q /sh sh Q /sh sh");
  const auto& found = page.painted;
  ASSERT_EQ(found.size(), 4U);
  EXPECT_EQ(found[0].clips.size(), 1U);
  EXPECT_EQ(found[1].clips.size(), 2U);
  EXPECT_EQ(found[1].clips[1]->rule, FillRule::evenodd);
  EXPECT_EQ(found[1].clips[1]->steps[1].kind, PagePath::Step::Kind::curve);
  EXPECT_EQ(found[2].clips.size(), 1U);
  EXPECT_TRUE(found[3].clips.empty());
}

TEST(PdfPage, AnotherColourEndsAPattern) {
  const std::string fill = " 0 0 9 9 re f ";
  for (const std::string color : {"1 0 0 rg", "0 g", "0 0 0 1 k", "/DeviceRGB cs"})
    EXPECT_EQ(painted_by("/Pattern cs /p scn" + fill + color + fill).painted.size(), 1U) << color;
}

TEST(PdfPage, FormsHaveTheirSpaceTheirBoxAndTheirOpacity) {
  const PageContent page = painted_by("/half gs 2 0 0 2 0 0 cm /x Do", "/half gs /sh sh");
  const auto& found = page.painted;
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(corners(found[0]).first, glm::dvec2(0, 220));
  EXPECT_EQ(found[0].clips.size(), 1U);
  EXPECT_EQ(found[0].opacity, 0.25);
}

TEST(PdfPage, AFormThatShowsItselfEnds) {
  EXPECT_EQ(painted_by("/x Do", "/sh sh /x Do").painted.size(), 1U);
}

TEST(PdfPage, WhatStatesNestWithoutEndIsRefused) {
  std::string content;
  for (int n = 0; n < 300; ++n) content += "q ";
  EXPECT_THROW(painted_by(content), InputError);
}

TEST(PdfPage, SoftMasksAreShadingsToo) {
  const PageContent page = painted_by("/masked gs /sh sh /plain gs /sh sh");
  const auto& found = page.painted;
  ASSERT_EQ(found.size(), 2U);
  ASSERT_TRUE(found[0].mask);
  EXPECT_EQ(found[0].mask->size(), 1U);
  EXPECT_FALSE(found[1].mask);
}

TEST(PdfPage, OperatorsWithoutOperandsAndNoiseDoNothing) {
  EXPECT_EQ(painted_by("cm re f Q Q ) >> /none sh /none gs 1 2 m W sh /sh sh").painted.size(), 1U);
  EXPECT_EQ(painted_by("BI /W 1 /H 1 /CS /G /BPC 8 ID x EI /sh sh").painted.size(), 1U);
}

TEST(PdfFile, SaysWhyItCannotBeOpened) {
  for (const std::string bytes : {"", "%PDF-1.7\n", "words", "\x1f\x8b"}) try {
      PdfFile(bytes, "a.pdf", "");
      ADD_FAILURE() << bytes;
    } catch (const InputError& error) {
      EXPECT_STREQ(error.what(), "a.pdf is damaged: none of its pages can be read.");
    }
}

TEST(PdfShading, ColoursAreThoseOfItsSpace) {
  const auto colors_of = [](const std::string& space, int components) {
    const std::string document =
        pdf_document(page_entries, "/sh sh", {square_shading(space, components)});
    const PageContent page = page_of(document);
    const PageShading read = read_shading(page.painted.at(0));
    std::vector<glm::dvec3> colors;
    for (const Components& color : read.patches.at(0).colors)
      colors.push_back(read.colors.srgb(color));
    return colors;
  };
  EXPECT_EQ(colors_of("/DeviceRGB", 3),
            (std::vector<glm::dvec3>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}}));
  EXPECT_EQ(colors_of("/DeviceGray", 1),
            (std::vector<glm::dvec3>{glm::dvec3(1), glm::dvec3(0), glm::dvec3(0), glm::dvec3(1)}));
  EXPECT_THROW(colors_of("[/Indexed /DeviceRGB 255 <00>]", 1), InputError);
}

TEST(PdfShading, TrianglesArePatchesWithATip) {
  BitWriter data;
  for (const std::uint32_t n : {0U, 9U, 18U}) data.add(0, 8).add({n, n * n / 9, n}, 8);
  const std::string triangle = pdf_stream(
      "/ShadingType 4 /ColorSpace /DeviceGray /BitsPerCoordinate 8 /BitsPerComponent 8 "
      "/BitsPerFlag 8 /Decode [0 255 0 255 0 1]",
      data.bytes());
  const PageContent page = page_of(pdf_document(page_entries, "/sh sh", {triangle}));
  const PageShading read = read_shading(page.painted.at(0));
  ASSERT_EQ(read.patches.size(), 1U);
  const ShadingPatch& patch = read.patches[0];
  for (std::size_t n = 0; n < 4; ++n) EXPECT_EQ(patch.side_point(2, n), patch.outer[6]);
  EXPECT_EQ(patch.colors[2], patch.colors[3]);
  EXPECT_FALSE(read.is_damaged);
}

struct ArtistsGrids {
  const char* name;
  /// Rows and columns, the smaller number first; nothing where it is not one grid.
  std::vector<std::pair<int, int>> sizes;
  /// How far sides with anchors may be from the curves of which one was made.
  double distance = 0;
};

/// The artist's grids, of which Illustrator writes only halves of halves.
class SharedPdfGrids : public testing::TestWithParam<ArtistsGrids> {};

TEST_P(SharedPdfGrids, AreWholeWhereHalvingAndAnchorsAreTakenBack) {
  const std::string bytes = shared_pdf(GetParam().name);
  if (bytes.empty())
    GTEST_SKIP() << GetParam().name << " is not beside the project, in ../shared/pdf";
  const PageContent page = page_of(bytes);
  std::vector<std::pair<int, int>> sizes;
  for (const PaintedShading& each : page.painted) {
    const PageShading read = read_shading(each);
    constexpr double tolerance = 0.02;
    const auto wholes = corners_in_srgb(without_halving(read.patches), read.colors);
    const JoinedPatches joined = without_anchors(wholes, tolerance);
    EXPECT_LE(joined.distance, GetParam().distance);
    const PatchSides sides(joined.patches, tolerance);
    const auto grids = page_grids(sides);
    const PageGrid& grid = grids.at(0);
    sizes.push_back({0, 0});
    if (grids.size() == 1) sizes.back() = std::minmax(grid.rows, grid.columns);
  }
  EXPECT_EQ(sizes, GetParam().sizes);
}

/// Whatever T-junctions there are, on both sides of curves too.
TEST_P(SharedPdfGrids, HalvesAndWhatIsJoinedOfThemMakeAMesh) {
  const std::string bytes = shared_pdf(GetParam().name);
  if (bytes.empty())
    GTEST_SKIP() << GetParam().name << " is not beside the project, in ../shared/pdf";
  const PageContent page = page_of(bytes);
  for (const PaintedShading& each : page.painted) {
    const PageShading read = read_shading(each);
    for (const auto& patches : {read.patches, without_halving(read.patches)}) {
      const MeshParts parts = page_mesh(corners_in_srgb(patches, read.colors), 0.02);
      EXPECT_EQ(build_mesh(parts).face_count(), int(patches.size()));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Files, SharedPdfGrids,
    testing::Values(
        ArtistsGrids{
            "illustrator/personwithdog.pdf",
            {{2, 3}, {3, 3}, {3, 3}, {3, 3}, {3, 3}, {2, 2}, {3, 3}, {3, 3}, {2, 2}, {3, 3}}},
        ArtistsGrids{"illustrator/issue13520.pdf", {6, {2, 3}}},
        ArtistsGrids{"illustrator/vectorapple.pdf", {{9, 9}, {4, 4}, {4, 23}}, 0.41},
        ArtistsGrids{"indesign/bug1703683_page2_reduced.pdf", {{6, 6}, {4, 5}, {4, 5}}, 0.02}));

TEST(SharedPdf, SmoothColoursOfInkscapeAreJoined) {
  const std::string name = "inkscape/smooth.pdf", bytes = shared_pdf(name);
  if (bytes.empty()) GTEST_SKIP() << name << " is not beside the project, in ../shared/pdf";
  const PageContent page = page_of(bytes);
  const PageShading read = read_shading(page.painted.at(0));
  const PatchSides sides(corners_in_srgb(read.patches, read.colors), 0.002);
  const auto grids = page_grids(sides);
  ASSERT_EQ(grids.size(), 1U);
  const auto smooth = smooth_grid(as_it_is(grids[0], sides));
  ASSERT_TRUE(smooth);
  EXPECT_EQ(smooth->rows, 11);
  EXPECT_EQ(smooth->columns, 8);
}

struct SharedFile {
  const char* name;
  /// The patches of each shading of its first page.
  std::vector<std::size_t> patches;
};

class SharedPdfPatches : public testing::TestWithParam<SharedFile> {};

TEST_P(SharedPdfPatches, HasThesePatches) {
  const std::string bytes = shared_pdf(GetParam().name);
  if (bytes.empty())
    GTEST_SKIP() << GetParam().name << " is not beside the project, in ../shared/pdf";
  const PdfFile file(bytes, GetParam().name, "");
  std::vector<std::size_t> patches;
  const PageContent page = file.page(0);
  for (const PaintedShading& each : page.painted)
    patches.push_back(read_shading(each).patches.size());
  EXPECT_EQ(patches, GetParam().patches);
}

INSTANTIATE_TEST_SUITE_P(
    Files, SharedPdfPatches,
    testing::Values(SharedFile{"inkscape/fruit.pdf", {132}},
                    SharedFile{"inkscape/fruit.eps.gs.pdf", {132}},
                    SharedFile{"inkscape/smooth.pdf", {5632}},
                    SharedFile{"inkscape/opacity.pdf", {169}},
                    SharedFile{"inkscape/two.pdf", {36, 280}},
                    SharedFile{"illustrator/personwithdog.pdf",
                               {166, 147, 149, 153, 148, 140, 152, 149, 140, 149}},
                    SharedFile{"illustrator/vectorapple.pdf", {1455, 245, 788}},
                    SharedFile{"other/typst-conic-type6.pdf", {24}}),
    [](const auto& file) {
      std::string name = file.param.name;
      for (char& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
      return name;
    });

}  // namespace
}  // namespace gradmesh
