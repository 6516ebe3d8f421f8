// Shadings as documents have them, to the grids that they become.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

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

/// A lattice of one cell over a square, whose corners have these greys.
std::size_t patches_of_cell(const std::array<std::uint32_t, 4>& greys) {
  BitWriter data;
  data.add({0, 0, greys[0], 90, 0, greys[1], 0, 90, greys[2], 90, 90, greys[3]}, 8);
  const std::string lattice = pdf_stream(
      "/ShadingType 5 /ColorSpace /DeviceGray /BitsPerCoordinate 8 /BitsPerComponent 8 "
      "/VerticesPerRow 2 /Decode [0 255 0 255 0 1]",
      data.bytes());
  const PageContent page = page_of(pdf_document(page_entries, "/sh sh", {lattice}));
  return read_shading(page.painted.at(0)).patches.size();
}

TEST(PdfShading, CellsOfALatticeAreTwoTrianglesWhereTheirColoursBend) {
  EXPECT_EQ(patches_of_cell({0, 100, 50, 150}), 1U);
  EXPECT_EQ(patches_of_cell({0, 100, 50, 153}), 1U);
  EXPECT_EQ(patches_of_cell({0, 100, 50, 160}), 2U);
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
