#include "formats/pdf/page/painted_patches.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <regex>

#include "base/error.h"
#include "formats/pdf/page/pdf_file.h"
#include "pdf_documents.h"
#include "pdf_shadings.h"

namespace gradmesh {
namespace {

/// Returns a document that paints square_shading(), half opaque, through a mask that paints `mask`.
std::string masked_document(const std::string& mask,
                            const std::string& shading = square_shading()) {
  return pdf_document(
      "/MediaBox [0 0 100 100] /Resources << /Shading << /sh 5 0 R /other 7 0 R >> /ExtGState << "
      "/half << /ca 0.5 >> /masked << /ca 0.5 /SMask << /S /Luminosity /G 6 0 R >> >> >> >>",
      "/masked gs /sh sh",
      {shading, pdf_stream("/Type /XObject /Subtype /Form /BBox [0 0 50 50]", mask),
       square_shading("/DeviceCMYK", 4)});
}

PaintedPatches first_painted(const std::string& document) {
  const PageContent page = PdfFile(document, "a.pdf", "").page(0);
  KeptShadings kept;
  return painted_patches(page.painted.at(0), kept);
}

std::array<double, 4> alphas(const PagePatch& patch) {
  return {patch.colors[0].a, patch.colors[1].a, patch.colors[2].a, patch.colors[3].a};
}

TEST(PaintedPatches, AMaskGivesTheLuminosityOfItsColours) {
  const PaintedPatches made = first_painted(masked_document("/sh sh"));
  ASSERT_EQ(made.patches.size(), 1U);
  EXPECT_FALSE(made.mask_left_out);
  // The box of the mask's form, beyond which nothing is seen.
  EXPECT_EQ(made.mask_clips.size(), 1U);
  // Of red, green, blue and white, half of each.
  const std::array<double, 4> wanted{0.15, 0.295, 0.055, 0.5};
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(alphas(made.patches[0])[k], wanted[k], 1e-12);
    EXPECT_NEAR(made.opacities.at(0)[k], wanted[k], 1e-12);
  }
  EXPECT_EQ(glm::dvec3(made.patches[0].colors[1]), glm::dvec3(0, 1, 0));
}

TEST(PaintedPatches, TheLastShadingOfAMaskLiesOnTop) {
  const PaintedPatches made = first_painted(masked_document("/other sh /half gs /sh sh"));
  EXPECT_FALSE(made.mask_left_out);
  EXPECT_NEAR(alphas(made.patches.at(0))[3], 0.25, 1e-12);
}

TEST(PaintedPatches, AMaskOfOtherPatchesIsLeftOut) {
  for (const std::string mask :
       {"", "0 0 9 9 re f", "2 0 0 2 0 0 cm /sh sh", "/masked gs /sh sh", "/none sh"}) {
    const PaintedPatches made = first_painted(masked_document(mask));
    EXPECT_TRUE(made.mask_left_out) << mask;
    EXPECT_EQ(alphas(made.patches.at(0)), (std::array<double, 4>{0.5, 0.5, 0.5, 0.5})) << mask;
  }
}

TEST(PaintedPatches, AMaskThatCannotBeReadIsLeftOut) {
  const std::string indexed = square_shading("[/Indexed /DeviceRGB 255 <00>]", 1);
  const std::string document = pdf_document(
      "/MediaBox [0 0 100 100] /Resources << /Shading << /sh 5 0 R /other 7 0 R >> /ExtGState << "
      "/masked << /SMask << /S /Luminosity /G 6 0 R >> >> >> >>",
      "/masked gs /sh sh",
      {square_shading(), pdf_stream("/Subtype /Form /BBox [0 0 50 50]", "/other sh"), indexed});
  EXPECT_TRUE(first_painted(document).mask_left_out);
}

TEST(PaintedPatches, SayWhatTheShadingIs) {
  const PaintedPatches made =
      first_painted(masked_document("/sh sh", square_shading("/DeviceCMYK", 4)));
  EXPECT_EQ(made.shading.type, 7);
  EXPECT_FALSE(made.shading.is_damaged);
  EXPECT_EQ(made.shading.patches.size(), 1U);
  // Red, green and blue of four inks are cyan, magenta and yellow, far apart.
  EXPECT_GT(made.patches.size(), 1U);
}

TEST(KeptShadings, AreReadOnce) {
  const std::string indexed = square_shading("[/Indexed /DeviceRGB 255 <00>]", 1);
  const PageContent page =
      PdfFile(pdf_document("/Resources << /Shading << /a 5 0 R /b 6 0 R >> >>",
                           "/a sh 2 0 0 2 0 0 cm /a sh /b sh", {square_shading(), indexed}),
              "a.pdf", "")
          .page(0);
  ASSERT_EQ(page.painted.size(), 3U);
  KeptShadings kept;
  const auto first = kept.read(page.painted[0]);
  EXPECT_EQ(kept.read(page.painted[1]), first);
  EXPECT_EQ(first->patches.at(0).outer[6], glm::dvec2(9, 9));
  for (int n = 0; n < 2; ++n) EXPECT_THROW(kept.read(page.painted[2]), InputError);
}

/// Returns the opacities of the corners of the patches of a sample, row by row; patches have only
/// the stops that those before them have not.
std::vector<CornerOpacities> opacities_of_sample(const std::string& path) {
  std::ifstream file(path);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const std::regex tag("<meshrow>|<meshpatch>|stop-opacity=\"([0-9.]+)\"");
  std::vector<std::vector<std::vector<double>>> rows;
  for (std::sregex_iterator found(text.begin(), text.end(), tag), end; found != end; ++found) {
    if (found->str() == "<meshrow>")
      rows.emplace_back();
    else if (found->str() == "<meshpatch>")
      rows.back().emplace_back();
    else
      rows.back().back().push_back(std::stod((*found)[1]));
  }
  std::vector<CornerOpacities> all;
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = 0; j < rows[i].size(); ++j) {
      const std::vector<double>& stops = rows[i][j];
      CornerOpacities corners;
      std::size_t next = 0;
      corners[0] = i == 0 && j == 0 ? stops.at(next++)
                   : i == 0         ? all.back()[1]
                                    : all.at((i - 1) * rows[0].size() + j)[3];
      corners[1] = i == 0 ? stops.at(next++) : all.at((i - 1) * rows[0].size() + j)[2];
      corners[2] = stops.at(next++);
      corners[3] = j == 0 ? stops.at(next++) : all.back()[2];
      EXPECT_EQ(next, stops.size());
      all.push_back(corners);
    }
  return all;
}

TEST(PaintedPatches, OpacitiesOfInkscapeAreThoseOfItsStops) {
  const std::string bytes = shared_pdf("inkscape/opacity.pdf");
  if (bytes.empty()) GTEST_SKIP() << "opacity.pdf is not beside the project, in ../shared/pdf";
  const PaintedPatches made = first_painted(bytes);
  EXPECT_FALSE(made.mask_left_out);
  const auto wanted = opacities_of_sample(GRADMESH_SOURCE_DIR "/samples/opacity.svg");
  ASSERT_EQ(wanted.size(), 169U);
  ASSERT_EQ(made.patches.size(), 169U);
  // The shape that the mesh fills has an opacity of its own.
  constexpr double of_shape = 0.9;
  for (std::size_t n = 0; n < wanted.size(); ++n)
    for (std::size_t k = 0; k < 4; ++k)
      EXPECT_NEAR(alphas(made.patches[n])[k], of_shape * wanted[n][k], 0.01 / 255) << n;
}

/// Adobe's programs have halved their patches far enough.
TEST(PaintedPatches, PatchesOfIllustratorAndInDesignAreNotDivided) {
  for (const std::string name :
       {"illustrator/personwithdog.pdf", "illustrator/issue13520.pdf",
        "illustrator/vectorapple.pdf", "indesign/bug1703683_page2_reduced.pdf"}) {
    const std::string bytes = shared_pdf(name);
    if (bytes.empty()) GTEST_SKIP() << name << " is not beside the project, in ../shared/pdf";
    const PageContent page = PdfFile(bytes, name, "").page(0);
    KeptShadings kept;
    EXPECT_FALSE(page.painted.empty()) << name;
    for (const PaintedShading& each : page.painted) {
      const PaintedPatches made = painted_patches(each, kept);
      EXPECT_EQ(made.patches, corners_in_srgb(made.shading.patches, made.shading.colors)) << name;
    }
  }
}

}  // namespace
}  // namespace gradmesh
