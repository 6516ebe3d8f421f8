// What a page shows by default, beside what its operators paint.

#include <gtest/gtest.h>

#include "base/error.h"
#include "formats/pdf/page/pdf_file.h"
#include "formats/pdf/page/read_shading.h"
#include "pdf_documents.h"
#include "pdf_shadings.h"

namespace gradmesh {
namespace {

/// Two layers, 6 and 7, of which the second is off.
constexpr const char* catalog = "/OCProperties << /OCGs [6 0 R 7 0 R] /D << /OFF [7 0 R] >> >>";
constexpr const char* layer = "<< /Type /OCG /Name (one) >>";

struct Layered {
  /// The membership that content belongs to, beside the layers `on` and `off`.
  std::string membership = "<< /Type /OCMD /OCGs 7 0 R >>";
  std::string content;
  std::string catalog = gradmesh::catalog;
  std::string second = layer;
};

PageContent page_of(const Layered& made, bool all_layers = false) {
  const std::string entries =
      "/MediaBox [0 0 100 100] /Resources << /Shading << /sh 5 0 R >> /XObject << /x 9 0 R >> "
      "/Properties << /on 6 0 R /off 7 0 R /both 8 0 R >> >>";
  const std::vector<std::string> objects{
      square_shading(), layer, made.second, made.membership,
      pdf_stream("/Type /XObject /Subtype /Form /BBox [0 0 50 50] /OC 8 0 R", "/sh sh")};
  const std::string document = pdf_document({{entries, made.content}}, objects, made.catalog);
  return PdfFile(document, "a.pdf", "").page(0, all_layers);
}

/// How many meshes are painted inside of content of the membership.
std::size_t shown_in(const std::string& membership) {
  const PageContent page = page_of({membership, "/OC /both BDC /sh sh EMC"});
  EXPECT_EQ(page.painted.size() + std::size_t(page.hidden), 1U) << membership;
  return page.painted.size();
}

TEST(PdfLayers, ThatAreOffAreLeftOut) {
  const PageContent page = page_of(
      {.content = "/OC /on BDC /sh sh EMC /OC /off BDC /sh sh /T BMC /sh sh EMC EMC /sh sh"});
  EXPECT_EQ(page.painted.size(), 2U);
  EXPECT_EQ(page.hidden, 2);
}

TEST(PdfLayers, ThatAreOffAreReadWhereAllAre) {
  const PageContent page = page_of({.content = "/OC /off BDC /sh sh EMC /x Do"}, true);
  EXPECT_EQ(page.painted.size(), 2U);
  EXPECT_EQ(page.hidden, 0);
}

TEST(PdfLayers, HideForms) {
  EXPECT_EQ(page_of({.content = "/x Do"}).hidden, 1);
  EXPECT_EQ(page_of({"<< /Type /OCMD /OCGs 6 0 R >>", "/x Do"}).hidden, 0);
  EXPECT_EQ(page_of({"<< /Type /OCMD /OCGs 6 0 R >>", "/OC /off BDC /x Do EMC"}).hidden, 1);
}

TEST(PdfLayers, AreOnOrOffByTheirBaseState) {
  const std::string content = "/OC /on BDC /sh sh EMC /OC /off BDC /sh sh EMC";
  const auto with = [&](const std::string& usual) {
    return page_of({.content = content, .catalog = "/OCProperties << /D << " + usual + " >> >>"})
        .painted.size();
  };
  EXPECT_EQ(with(""), 2U);
  EXPECT_EQ(with("/BaseState /OFF"), 0U);
  EXPECT_EQ(with("/BaseState /OFF /ON [7 0 R]"), 1U);
  EXPECT_EQ(with("/BaseState /Unchanged /OFF [6 0 R 7 0 R]"), 0U);
}

TEST(PdfLayers, AreAsTheirUsageSaysOfViewing) {
  const auto with = [&](const std::string& event, const std::string& usage) {
    return page_of({.content = "/OC /off BDC /sh sh EMC",
                    .catalog = "/OCProperties << /D << /AS [<< /Event /" + event +
                               " /OCGs [7 0 R] /Category [/View /Print] >>] >> >>",
                    .second = "<< /Type /OCG /Name (two) /Usage << " + usage + " >> >>"})
        .painted.size();
  };
  EXPECT_EQ(with("View", "/View << /ViewState /OFF >>"), 0U);
  EXPECT_EQ(with("View", "/View << /ViewState /ON >>"), 1U);
  EXPECT_EQ(with("View", "/View << /ViewState /ON >> /Print << /PrintState /OFF >>"), 0U);
  EXPECT_EQ(with("Print", "/View << /ViewState /OFF >>"), 1U);
}

TEST(PdfLayers, AreTakenTogetherByPoliciesAndExpressions) {
  const auto policy = [](const std::string& p) {
    return shown_in("<< /Type /OCMD /OCGs [6 0 R 7 0 R null] /P /" + p + " >>");
  };
  EXPECT_EQ(policy("AnyOn"), 1U);
  EXPECT_EQ(policy("AllOn"), 0U);
  EXPECT_EQ(policy("AnyOff"), 1U);
  EXPECT_EQ(policy("AllOff"), 0U);
  EXPECT_EQ(shown_in("<< /Type /OCMD /OCGs [] >>"), 1U);
  const auto expression = [](const std::string& ve) {
    return shown_in("<< /Type /OCMD /OCGs 6 0 R /VE [" + ve + "] >>");
  };
  EXPECT_EQ(expression("/Not 6 0 R"), 0U);
  EXPECT_EQ(expression("/Not 7 0 R"), 1U);
  EXPECT_EQ(expression("/And 6 0 R 7 0 R"), 0U);
  EXPECT_EQ(expression("/And 6 0 R [/Not 7 0 R]"), 1U);
  EXPECT_EQ(expression("/Or 7 0 R [/Not 6 0 R]"), 0U);
}

TEST(PdfLayers, WithoutAnEndDoNotLoop) {
  EXPECT_EQ(shown_in("<< /Type /OCMD /OCGs 8 0 R >>"), 1U);
  EXPECT_EQ(page_of({.content = "EMC EMC /OC BDC /sh sh /OC /off BDC /sh sh"}).painted.size(), 1U);
}

/// The page that paints a square through the form of a soft mask, or over what is said.
PageContent masked(const std::string& mask, const std::string& form,
                   const std::string& content = "/m gs /sh sh") {
  const std::string entries =
      "/MediaBox [0 0 100 100] /Resources << /Shading << /sh 5 0 R >> /ExtGState << /m << /SMask "
      "<< /G 6 0 R " +
      mask + " >> >> /none << /SMask /None >> >> >>";
  const std::string group =
      "/Type /XObject /Subtype /Form /Group << /S /Transparency >> "
      "/Resources << /ExtGState << /half << /ca 0.5 >> >> /Shading << /sh 5 0 "
      "R >> >>";
  return PdfFile(pdf_document(entries, content, {square_shading(), pdf_stream(group, form)}),
                 "a.pdf", "")
      .page(0);
}

TEST(PdfAlphaMask, OfOneAreaIsAClipPath) {
  const PageContent page = masked("/S /Alpha", "1 2 3 4 re f");
  ASSERT_EQ(page.painted.size(), 1U);
  EXPECT_FALSE(page.painted[0].mask);
  ASSERT_EQ(page.painted[0].clips.size(), 1U);
  EXPECT_EQ(page.painted[0].clips[0]->steps.front().points[2], glm::dvec2(1, 98));
  EXPECT_EQ(page.painted[0].opacity, 1);
}

TEST(PdfAlphaMask, HasItsOpacity) {
  EXPECT_EQ(masked("/S /Alpha", "/half gs 1 2 3 4 re f").painted.at(0).opacity, 0.5);
}

TEST(PdfAlphaMask, OfAreasThatLieApartIsOnePath) {
  const PageContent page = masked("/S /Alpha", "1 2 3 4 re f 50 50 m 60 50 l 60 60 l f");
  ASSERT_EQ(page.painted.at(0).clips.size(), 1U);
  EXPECT_EQ(page.painted[0].clips[0]->steps.size(), 8U);
}

TEST(PdfAlphaMask, EndsWithItsState) {
  const PageContent page = masked("/S /Alpha", "1 2 3 4 re f",
                                  "q /m gs /sh sh Q /sh sh "
                                  "/m gs /none gs /sh sh");
  ASSERT_EQ(page.painted.size(), 3U);
  EXPECT_EQ(page.painted[0].clips.size(), 1U);
  EXPECT_TRUE(page.painted[1].clips.empty());
  EXPECT_TRUE(page.painted[2].clips.empty());
}

TEST(PdfAlphaMask, ThatIsAnythingElseIsTold) {
  for (const char* form :
       {"1 2 3 4 re S", "1 2 3 4 re f 2 3 4 5 re f", "/sh sh", "BI /W 1 /H 1 /CS /G /BPC 8 ID x EI",
        "1 2 3 4 re f /half gs 50 50 9 9 re f"}) {
    const PageContent page = masked("/S /Alpha", form);
    ASSERT_EQ(page.painted.size(), 1U) << form;
    ASSERT_TRUE(page.painted[0].mask) << form;
    EXPECT_TRUE(page.painted[0].mask->empty()) << form;
  }
  EXPECT_TRUE(masked("/S /Alpha /TR 6 0 R", "1 2 3 4 re f").painted.at(0).mask);
}

/// What is painted with a tiling pattern whose cells, 10 x 10, have a square.
PageContent tiled(const std::string& content) {
  const std::string entries =
      "/MediaBox [0 0 100 100] /Resources << /Shading << /sh 5 0 R >> /Pattern << /t 6 0 R >> >>";
  const std::string cell =
      "/PatternType 1 /PaintType 1 /TilingType 1 /BBox [0 0 10 10] /XStep 12 "
      "/YStep 12 /Matrix [2 0 0 2 0 0] /Resources << /Shading << /sh 5 0 R >> >>";
  return PdfFile(pdf_document(entries, "/Pattern cs /Pattern CS /t scn /t SCN " + content,
                              {square_shading(), pdf_stream(cell, "/sh sh")}),
                 "a.pdf", "")
      .page(0);
}

TEST(PdfTiling, PaintsACellOnceInTheMiddle) {
  const PageContent page = tiled("0 0 100 100 re f");
  ASSERT_EQ(page.painted.size(), 1U);
  EXPECT_TRUE(page.painted[0].is_repeated);
  EXPECT_EQ(page.painted[0].to_page.point({0, 0}), glm::dvec2(48, 52));
  EXPECT_EQ(page.painted[0].clips.size(), 2U);
}

TEST(PdfTiling, OfOneCellIsNotRepeated) {
  const PageContent page = tiled("25 25 18 18 re f");
  ASSERT_EQ(page.painted.size(), 1U);
  EXPECT_FALSE(page.painted[0].is_repeated);
  EXPECT_EQ(page.painted[0].to_page.point({0, 0}), glm::dvec2(24, 76));
}

TEST(PdfTiling, StrokesToo) {
  const PageContent page = tiled("0 0 m 100 100 l S");
  ASSERT_EQ(page.painted.size(), 1U);
  EXPECT_TRUE(page.painted[0].stroke);
}

/// A page with one annotation, whose appearance is a square in a box of 10 x 10.
PageContent annotated(const std::string& annotation) {
  const std::string entries =
      "/MediaBox [0 0 100 100] /Annots [<< /Type /Annot /Subtype /Stamp " + annotation + " >>]";
  const std::string form =
      "/Type /XObject /Subtype /Form /BBox [0 0 10 10] /Matrix [0 1 -1 0 0 0] "
      "/Resources << /Shading << /sh 5 0 R >> >>";
  return PdfFile(pdf_document(entries, "", {square_shading(), pdf_stream(form, "/sh sh")}), "a.pdf",
                 "")
      .page(0);
}

TEST(PdfAnnotation, ShowsItsAppearanceInItsRectangle) {
  const PageContent page = annotated("/Rect [20 30 40 50] /AP << /N 6 0 R >>");
  ASSERT_EQ(page.painted.size(), 1U);
  // Turned by a quarter, what was at the lower left is at the lower right.
  EXPECT_EQ(page.painted[0].to_page.point({0, 0}), glm::dvec2(40, 70));
  EXPECT_EQ(page.painted[0].to_page.point({10, 0}), glm::dvec2(40, 50));
}

TEST(PdfAnnotation, IsLeftOutWhereNoViewerShowsIt) {
  const std::string shown = "/Rect [20 30 40 50] /AP << /N 6 0 R >> ";
  EXPECT_TRUE(annotated(shown + "/F 2").painted.empty());
  EXPECT_TRUE(annotated(shown + "/F 32").painted.empty());
  EXPECT_EQ(annotated(shown + "/F 4").painted.size(), 1U);
  EXPECT_TRUE(
      annotated("/Rect [20 30 40 50] /AP << /N << /On 6 0 R >> >> /AS /Off").painted.empty());
  EXPECT_EQ(annotated("/Rect [20 30 40 50] /AP << /N << /On 6 0 R >> >> /AS /On").painted.size(),
            1U);
  EXPECT_TRUE(annotated("/Rect [20 30 40 50]").painted.empty());
}

/// What is painted by a pattern, `p`, which is a square, and by text in fonts of which the document
/// holds one, `boxes`, not, and `glyphs` has contents as its glyphs: `m` a mesh, `a` an area.
PageContent with_text(const std::string& content) {
  const std::string entries =
      "/MediaBox [0 0 100 100] /Resources << /Shading << /sh 5 0 R >> /Pattern << /p 6 0 R >> "
      "/Font << /boxes << /Type /Font /Subtype /Type1 /BaseFont /Own /FirstChar 97 /Widths [500 "
      "600] "
      ">> /glyphs 7 0 R >> >>";
  const std::vector<std::string> objects{
      square_shading(), "<< /PatternType 2 /Shading 5 0 R >>",
      "<< /Type /Font /Subtype /Type3 /FontMatrix [0.1 0 0 0.1 0 0] /FontBBox [0 0 9 9] /FirstChar "
      "97 "
      "/Widths [10 20] /Encoding << /Differences [97 /a /m] >> /CharProcs << /a 8 0 R /m 9 0 R >> "
      "/Resources << /Shading << /sh 5 0 R >> >> >>",
      pdf_stream("", "10 0 0 0 9 9 d1 0 0 9 9 re f"), pdf_stream("", "20 0 d0 /sh sh")};
  return PdfFile(pdf_document(entries, content, objects), "a.pdf", "").page(0);
}

Box box_of(const PagePath& path) {
  Box box;
  for (const PagePath::Step& step : path.steps)
    for (const glm::dvec2 point : step.points) box.add(point);
  return box;
}

TEST(PdfText, ThatAMeshPaintsIsOneAreaPerText) {
  const PageContent page = with_text(
      "/Pattern cs /p scn BT /boxes 10 Tf 20 30 Td (ab) Tj [(a) -1000 "
      "(b)] TJ ET");
  ASSERT_EQ(page.painted.size(), 1U);
  EXPECT_TRUE(page.painted[0].has_text_boxes);
  ASSERT_EQ(page.painted[0].clips.size(), 1U);
  const PagePath& path = *page.painted[0].clips[0];
  EXPECT_EQ(path.steps.size(), 4U * 5);
  EXPECT_EQ(path.rule, FillRule::nonzero);
  // Two letters of 5 and 6 points, twice, and a gap of 10; they reach 2 below the line and 9 above.
  EXPECT_NEAR(box_of(path).low().x, 20, 1e-9);
  EXPECT_NEAR(box_of(path).high().x, 52, 1e-9);
  EXPECT_NEAR(box_of(path).low().y, 100 - 39, 1e-9);
  EXPECT_NEAR(box_of(path).high().y, 100 - 28, 1e-9);
}

TEST(PdfText, LiesWhereItsStateSays) {
  const auto box = [](const std::string& operators) {
    const PageContent page = with_text("/Pattern cs /p scn BT /boxes 10 Tf " + operators + " ET");
    return page.painted.empty() ? Box() : box_of(*page.painted[0].clips.at(0));
  };
  EXPECT_NEAR(box("50 Tz (a) Tj").high().x, 2.5, 1e-9);
  EXPECT_NEAR(box("3 Tc (aa) Tj").high().x, 5 + 3 + 5, 1e-9);
  EXPECT_NEAR(box("3 Tw (a a) Tj").high().x, 5 + 5.5 + 3 + 5, 1e-9);
  EXPECT_NEAR(box("4 Ts (a) Tj").high().y, 100 - 4 + 2, 1e-9);
  EXPECT_NEAR(box("20 TL T* (a) Tj").high().y, 100 + 20 + 2, 1e-9);
  EXPECT_NEAR(box("20 TL (a) '").high().y, 100 + 20 + 2, 1e-9);
  EXPECT_NEAR(box("0 -7 TD T* (a) Tj").high().y, 100 + 14 + 2, 1e-9);
  EXPECT_NEAR(box("1 3 (aa) \"").high().x, 5 + 3 + 5, 1e-9);
  EXPECT_NEAR(box("2 0 0 2 1 0 Tm (a) Tj").high().x, 11, 1e-9);
  EXPECT_TRUE(box("3 Tr (a) Tj").empty());
}

TEST(PdfText, IsPaintedBeforeItsStateChanges) {
  const PageContent page = with_text(
      "/Pattern cs /p scn BT /boxes 10 Tf (a) Tj 1 0 0 rg (a) Tj /Pattern cs /p scn (a) Tj ET");
  EXPECT_EQ(page.painted.size(), 2U);
}

TEST(PdfText, MayBeStroked) {
  const PageContent page = with_text("/Pattern CS /p SCN 3 w BT 1 Tr /boxes 10 Tf (a) Tj ET");
  ASSERT_EQ(page.painted.size(), 1U);
  ASSERT_TRUE(page.painted[0].stroke);
  EXPECT_EQ(page.painted[0].stroke->line.width, 3);
  EXPECT_EQ(page.painted[0].stroke->path.steps.size(), 5U);
}

TEST(PdfText, IsSeenThroughFromItsEndOn) {
  const PageContent page =
      with_text("q BT 7 Tr /boxes 10 Tf (a) Tj 0 20 Td (b) Tj /sh sh ET /sh sh Q /sh sh");
  ASSERT_EQ(page.painted.size(), 3U);
  EXPECT_TRUE(page.painted[0].clips.empty());
  ASSERT_EQ(page.painted[1].clips.size(), 1U);
  EXPECT_EQ(page.painted[1].clips[0]->steps.size(), 10U);
  EXPECT_TRUE(page.painted[1].has_text_boxes);
  EXPECT_TRUE(page.painted[2].clips.empty());
  EXPECT_FALSE(page.painted[2].has_text_boxes);
}

TEST(PdfText, OfNothingHidesAll) {
  const PageContent page = with_text("BT 7 Tr /boxes 10 Tf () Tj ET /sh sh");
  ASSERT_EQ(page.painted.at(0).clips.size(), 1U);
  EXPECT_TRUE(page.painted[0].clips[0]->steps.empty());
}

TEST(PdfText, HasGlyphsThatAreContents) {
  const PageContent page = with_text("BT /glyphs 10 Tf 20 30 Td (aba) Tj (b) Tj ET");
  ASSERT_EQ(page.painted.size(), 2U);
  EXPECT_EQ(page.painted[0].to_page.point({0, 0}), glm::dvec2(30, 70));
  EXPECT_EQ(page.painted[0].to_page.point({9, 0}), glm::dvec2(39, 70));
  EXPECT_EQ(page.painted[1].to_page.point({0, 0}), glm::dvec2(60, 70));
}

TEST(PdfText, FillsGlyphsByThePatternOfThePage) {
  const PageContent page = with_text("/Pattern cs /p scn BT /glyphs 20 Tf 20 30 Td (a) Tj ET");
  ASSERT_EQ(page.painted.size(), 1U);
  EXPECT_EQ(page.painted[0].to_page.point({0, 0}), glm::dvec2(0, 100));
  ASSERT_EQ(page.painted[0].clips.size(), 1U);
  EXPECT_NEAR(box_of(*page.painted[0].clips[0]).high().x, 20 + 18, 1e-9);
}

TEST(PdfText, WithoutAFontShowsNothing) {
  for (const char* content :
       {"/Pattern cs /p scn BT (a) Tj ET", "/Pattern cs /p scn BT /no 9 Tf (a) Tj",
        "/Pattern cs /p scn BT Tf Tj TJ Tm ' \" (a) TJ 1 Tj ET ET BT BT"})
    EXPECT_TRUE(with_text(content).painted.empty()) << content;
}

/// The colour of the square's first corner, red, in a space that resources name or replace.
glm::dvec3 first_color(const std::string& space, const std::string& spaces) {
  const std::string entries =
      "/MediaBox [0 0 100 100] /Resources << /Shading << /sh 5 0 R >> "
      "/ColorSpace << " +
      spaces + " >> >>";
  const PageContent page =
      PdfFile(pdf_document(entries, "/sh sh", {square_shading(space)}), "a.pdf", "").page(0);
  const PageShading read = read_shading(page.painted.at(0));
  return read.colors.srgb(read.patches.at(0).colors[0]);
}

TEST(PdfSpaces, AreThoseThatResourcesName) {
  const glm::dvec3 red(1, 0, 0);
  EXPECT_EQ(first_color("/mine", "/mine /DeviceRGB"), red);
  EXPECT_THROW(first_color("/mine", "/other /DeviceRGB"), InputError);
  EXPECT_THROW(first_color("/mine", "/mine /mine"), InputError);
}

TEST(PdfSpaces, OfDevicesAreReplacedByDefaults) {
  // Of which the same numbers are hardly any light.
  const std::string lab = "[/Lab << /WhitePoint [0.9505 1 1.089] >>]";
  EXPECT_EQ(first_color("/DeviceRGB", "/DefaultRGB /DeviceRGB"), glm::dvec3(1, 0, 0));
  // What does not have as many components is no default.
  EXPECT_EQ(first_color("/DeviceRGB", "/DefaultRGB [/CalGray << /Gamma 2 >>]"),
            glm::dvec3(1, 0, 0));
  EXPECT_LT(first_color("/DeviceRGB", "/DefaultRGB " + lab).r, 0.1);
}

}  // namespace
}  // namespace gradmesh
