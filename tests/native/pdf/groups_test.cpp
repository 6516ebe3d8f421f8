// What transparency groups do to the meshes of a page.
#include <gtest/gtest.h>

#include "formats/pdf/page/pdf_file.h"
#include "pdf_shadings.h"

namespace gradmesh {
namespace {

/// What a page paints that shows `inner` in a form, a group with these entries, inside of another.
std::vector<PaintedShading> painted_by(const std::string& content, const std::string& group,
                                       const std::string& inner) {
  const std::string resources =
      "/Resources << /Shading << /sh 5 0 R >> /XObject << /x 6 0 R /y 7 0 R >> /ExtGState << "
      "/half << /ca 0.5 >> /multiply << /BM /Multiply >> /screen << /BM /Screen >> /masked << "
      "/SMask << /S /Luminosity /G 8 0 R >> >> /none << /SMask /None >> >> >> ";
  const std::string form = "/Type /XObject /Subtype /Form /BBox [0 0 90 90] " + resources;
  return PdfFile(
             pdf_document("/MediaBox [0 0 100 100] " + resources, content,
                          {square_shading(),
                           pdf_stream(form + "/Group << /S /Transparency " + group + " >>", inner),
                           pdf_stream(form + "/Group << /S /Transparency >>", "/half gs /x Do"),
                           pdf_stream(form, "/sh sh")}),
             "a.pdf", "")
      .page(0)
      .painted;
}

constexpr const char* two = "/sh sh /sh sh";

TEST(PdfGroup, OfOneMeshGivesItWhatItHas) {
  const auto painted = painted_by("/half gs /screen gs /x Do", "", "/half gs /sh sh");
  ASSERT_EQ(painted.size(), 1U);
  EXPECT_EQ(painted[0].opacity, 0.25);
  EXPECT_EQ(painted[0].blend_mode, "screen");
  EXPECT_FALSE(painted[0].group);
}

TEST(PdfGroup, OfTwoMeshesIsMixedAtOnce) {
  const auto painted = painted_by("/half gs /screen gs /x Do", "", two);
  ASSERT_EQ(painted.size(), 2U);
  ASSERT_TRUE(painted[0].group);
  EXPECT_EQ(painted[0].group, painted[1].group);
  EXPECT_EQ(painted[0].group->opacity, 0.5);
  EXPECT_EQ(painted[0].group->blend_mode, "screen");
  EXPECT_TRUE(painted[0].group->is_as_in_svg);
  EXPECT_FALSE(painted[0].group->around);
  EXPECT_EQ(painted[0].opacity, 1);
  EXPECT_EQ(painted[0].blend_mode, "normal");
}

TEST(PdfGroup, ShownTwiceIsTwo) {
  const auto painted = painted_by("/half gs /x Do /x Do", "", two);
  ASSERT_EQ(painted.size(), 4U);
  EXPECT_EQ(painted[2].group, painted[3].group);
  EXPECT_NE(painted[1].group, painted[2].group);
}

TEST(PdfGroup, LiesInAnother) {
  const auto painted = painted_by("/half gs /y Do", "", two);
  ASSERT_EQ(painted.size(), 2U);
  ASSERT_TRUE(painted[0].group && painted[0].group->around);
  EXPECT_EQ(painted[0].group->around->opacity, 0.5);
}

TEST(PdfGroup, ThatChangesNothingIsNone) {
  for (const char* group : {"", "/I true", "/K true"})
    EXPECT_FALSE(painted_by("/x Do", group, two).at(0).group) << group;
  // Nor is it around one that changes something.
  const auto painted = painted_by("/y Do", "", two);
  ASSERT_TRUE(painted.at(0).group);
  EXPECT_FALSE(painted[0].group->around);
}

TEST(PdfGroup, ThatIsIsolatedHasNothingBelow) {
  const auto one = painted_by("/x Do", "/I true", "/multiply gs /sh sh");
  EXPECT_EQ(one.at(0).blend_mode, "normal");
  const auto both = painted_by("/x Do", "/I true", "/sh sh /multiply gs /sh sh");
  EXPECT_EQ(both.at(1).blend_mode, "multiply");
  ASSERT_TRUE(both[1].group);
  EXPECT_TRUE(both[1].group->is_isolated);
  EXPECT_TRUE(both[1].group->is_as_in_svg);
  EXPECT_EQ(painted_by("/x Do", "", "/multiply gs /sh sh").at(0).blend_mode, "multiply");
}

TEST(PdfGroup, ThatSvgDoesNotHaveIsKnown) {
  const auto is_as_in_svg = [](const std::string& group, const std::string& inner) {
    const auto painted = painted_by("/half gs /x Do", group, inner);
    return painted.at(0).group && painted[0].group->is_as_in_svg;
  };
  const std::string blended = "/sh sh /multiply gs /sh sh", opaque = two;
  EXPECT_TRUE(is_as_in_svg("/K true", opaque));
  EXPECT_FALSE(is_as_in_svg("/K true", "/sh sh /half gs /sh sh"));
  EXPECT_TRUE(is_as_in_svg("/I true", blended));
  EXPECT_FALSE(is_as_in_svg("", blended));
}

TEST(PdfGroup, WithAModeOfItsOwnIsNotThatOfOneMeshWithAnother) {
  const auto both = painted_by("/screen gs /x Do", "", "/multiply gs /sh sh");
  ASSERT_TRUE(both.at(0).group);
  EXPECT_EQ(both[0].blend_mode, "multiply");
  EXPECT_EQ(both[0].group->blend_mode, "screen");
  EXPECT_FALSE(both[0].group->is_as_in_svg);
  EXPECT_EQ(painted_by("/screen gs /x Do", "/I true", "/multiply gs /sh sh").at(0).blend_mode,
            "screen");
}

TEST(PdfGroup, KeepsItsMaskWhateverIsInside) {
  EXPECT_TRUE(painted_by("/masked gs /x Do", "", "/none gs /sh sh").at(0).mask);
  EXPECT_FALSE(painted_by("/masked gs /none gs /x Do", "", "/sh sh").at(0).mask);
  const auto twice = painted_by("/masked gs /x Do", "", "/masked gs /sh sh");
  ASSERT_TRUE(twice.at(0).mask);
  EXPECT_TRUE(twice[0].mask->empty());
}

}  // namespace
}  // namespace gradmesh
