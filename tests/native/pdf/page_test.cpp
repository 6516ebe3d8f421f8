#include <gtest/gtest.h>

#include <zstd.h>

#include <algorithm>
#include <memory>
#include <qpdf/Pl_Flate.hh>
#include <qpdf/Pl_String.hh>
#include <random>
#include <tuple>

#include "base/error.h"
#include "formats/pdf/page/pdf_file.h"
#include "formats/pdf/page/read_shading.h"
#include "pdf_documents.h"
#include "pdf_shadings.h"
#include "shading_bits.h"

namespace gradmesh {
namespace {

constexpr const char* page_entries =
    "/MediaBox [10 20 110 220] /Resources << /Shading << /sh 5 0 R >> /Pattern << /p 6 0 R >> "
    "/XObject << /x 7 0 R >> /ExtGState << /half << /ca 0.5 >> "
    "/stroked << /CA 0.25 /LW 7 /LC 1 /LJ 2 /ML 3 /D [[4 5] 6] >> /masked << /SMask << /S "
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

/// The stroke that a content paints by a mesh, and nothing else.
PageStroke stroked_by(const std::string& content) {
  const PageContent page = painted_by("/Pattern CS /p SCN " + content);
  EXPECT_EQ(page.painted.size(), 1U) << content;
  if (page.painted.size() != 1) return {};
  EXPECT_TRUE(page.painted[0].stroke) << content;
  return page.painted[0].stroke ? *page.painted[0].stroke : PageStroke{};
}

std::vector<PagePath::Step::Kind> kinds(const PagePath& path) {
  std::vector<PagePath::Step::Kind> all;
  for (const PagePath::Step& step : path.steps) all.push_back(step.kind);
  return all;
}

TEST(PdfStroke, IsAPathOnThePage) {
  const PageContent page =
      painted_by("q 0 0 99 99 re W n /Pattern CS /p SCN 3 0 0 3 10 20 cm 1 2 m 9 4 l S Q /sh sh");
  const auto& found = page.painted;
  ASSERT_EQ(found.size(), 2U);
  ASSERT_TRUE(found[0].stroke);
  const auto& steps = found[0].stroke->path.steps;
  ASSERT_EQ(steps.size(), 2U);
  EXPECT_EQ(steps[0].points[2], glm::dvec2(3, 194));
  EXPECT_EQ(steps[1].points[2], glm::dvec2(27, 188));
  // It is no clip, and its pattern lies in the space of the page.
  EXPECT_EQ(found[0].clips.size(), 1U);
  EXPECT_EQ(corners(found[0]).second, glm::dvec2(8, 202));
  EXPECT_FALSE(found[1].stroke);
}

TEST(PdfStroke, HasTheStyleOfItsState) {
  const LineStyle usual = stroked_by("0 0 m 9 9 l S").line;
  EXPECT_EQ(usual.width, 1);
  EXPECT_EQ(usual.cap, LineCap::butt);
  EXPECT_EQ(usual.join, LineJoin::miter);
  EXPECT_EQ(usual.miter_limit, 10);
  EXPECT_TRUE(usual.dashes.empty());
  for (const std::string set : {"7 w 1 J 2 j 3 M [4 5] 6 d", "/stroked gs"}) {
    const LineStyle line = stroked_by(set + " q 1 w 0 J 0 j 9 M [] 0 d Q 0 0 m 9 9 l S").line;
    EXPECT_EQ(line.width, 7);
    EXPECT_EQ(line.cap, LineCap::round);
    EXPECT_EQ(line.join, LineJoin::bevel);
    EXPECT_EQ(line.miter_limit, 3);
    EXPECT_EQ(line.dashes, (std::vector<double>{4, 5}));
    EXPECT_EQ(line.dash_phase, 6);
  }
}

TEST(PdfStroke, HasLengthsOfThePage) {
  const LineStyle line = stroked_by("2 w [3] 1 d 8 0 0 -2 5 5 cm 0 0 m 9 9 l S").line;
  EXPECT_DOUBLE_EQ(line.width, 8);
  ASSERT_EQ(line.dashes.size(), 1U);
  EXPECT_DOUBLE_EQ(line.dashes[0], 12);
  EXPECT_DOUBLE_EQ(line.dash_phase, 4);
}

TEST(PdfStroke, IsWiderInOneDirectionAsThePageHasIt) {
  EXPECT_EQ(stroked_by("8 0 0 2 5 5 cm 0 0 m 9 9 l S").pen.linear, glm::dmat2(2, 0, 0, 0.5));
  // What turns and scales leaves circles, and nothing is thinner than a line that can just be seen.
  EXPECT_EQ(stroked_by("0 3 -3 0 5 5 cm 0 0 m 9 9 l S").pen, Affine());
  EXPECT_EQ(stroked_by("8 0 0 2 5 5 cm 0 w 0 0 m 9 9 l S").pen, Affine());
  EXPECT_EQ(stroked_by("8 0 0 0 5 5 cm 0 0 m 9 9 l S").pen, Affine());
  // The ellipse of a map is that of its pen, times the width.
  const glm::dmat2 skewed(3, -1, 2, -5);
  const PageStroke stroke = stroked_by("2 w 3 1 2 5 0 0 cm 0 0 m 9 9 l S");
  const glm::dmat2 pen = 0.5 * stroke.line.width * stroke.pen.linear;
  const glm::dmat2 apart = pen * glm::transpose(pen) - skewed * glm::transpose(skewed);
  for (int column = 0; column < 2; ++column) {
    EXPECT_NEAR(apart[column].x, 0, 1e-12);
    EXPECT_NEAR(apart[column].y, 0, 1e-12);
  }
}

TEST(PdfStroke, IsOpaqueAsStrokesAre) {
  const std::string line = " 0 0 m 9 9 l S ";
  const PageContent page =
      painted_by("/Pattern CS /p SCN /half gs" + line + "/stroked gs" + line + "/sh sh");
  const auto& found = page.painted;
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].opacity, 1);
  EXPECT_EQ(found[1].opacity, 0.25);
  EXPECT_EQ(found[2].opacity, 0.5);
}

TEST(PdfStroke, LiesAboveTheFill) {
  const std::string both = "/Pattern CS /p SCN /Pattern cs /p scn 0 0 m 9 0 l 9 9 l ";
  for (const auto& [painting, closes, rule] :
       {std::tuple("B", false, FillRule::nonzero), std::tuple("B*", false, FillRule::evenodd),
        std::tuple("b", true, FillRule::nonzero), std::tuple("b*", true, FillRule::evenodd)}) {
    const PageContent page = painted_by(both + painting);
    const auto& found = page.painted;
    ASSERT_EQ(found.size(), 2U) << painting;
    EXPECT_FALSE(found[0].stroke) << painting;
    ASSERT_EQ(found[0].clips.size(), 1U) << painting;
    EXPECT_EQ(found[0].clips[0]->rule, rule) << painting;
    ASSERT_TRUE(found[1].stroke) << painting;
    EXPECT_TRUE(found[1].clips.empty()) << painting;
    EXPECT_EQ(found[1].stroke->path.steps.size(), closes ? 4U : 3U) << painting;
  }
  // Either has a paint of its own.
  const std::string square = " 0 0 9 9 re B ";
  EXPECT_TRUE(stroked_by(square).path.steps.size() == 5);
  EXPECT_FALSE(painted_by("/Pattern cs /p scn" + square).painted.at(0).stroke);
  EXPECT_FALSE(painted_by("/Pattern cs /p scn 1 0 0 RG" + square).painted.at(0).stroke);
}

TEST(PdfStroke, IsClosedOnce) {
  using enum PagePath::Step::Kind;
  using Kinds = std::vector<PagePath::Step::Kind>;
  const std::string corner = "0 0 m 9 0 l 9 9 l ";
  EXPECT_EQ(kinds(stroked_by(corner + "S").path), (Kinds{move, line, line}));
  EXPECT_EQ(kinds(stroked_by(corner + "s").path), (Kinds{move, line, line, close}));
  EXPECT_EQ(kinds(stroked_by(corner + "h s").path), (Kinds{move, line, line, close}));
  // Inkscape goes back to where a closed path began.
  EXPECT_EQ(kinds(stroked_by("5 5 m " + corner + "h 0 0 m S").path),
            (Kinds{move, line, line, close}));
}

TEST(PdfStroke, AnotherColourEndsItsPattern) {
  const std::string line = " 0 0 m 9 9 l S ";
  for (const std::string color :
       {"1 0 0 RG", "0 G", "0 0 0 1 K", "/DeviceRGB CS", "0 SC", "0 SCN", "q /none SCN"})
    stroked_by(line + color + line);
  for (const std::string color : {"1 0 0 rg", "0 g", "0 0 0 1 k", "/DeviceRGB cs", "0 sc"})
    EXPECT_EQ(painted_by("/Pattern CS /p SCN " + color + line).painted.size(), 1U) << color;
  EXPECT_EQ(painted_by("/Pattern CS /p SCN q 0 G Q" + line).painted.size(), 1U);
}

TEST(PdfStroke, WhatIsNoStyleOrNoPathDoesNothing) {
  const LineStyle line = stroked_by(
                             "2 w -1 w /a w J (a) j 0.5 M [1 -1] 0 d [/a] 0 d [0 0] 0 d 1 d "
                             "1000000000000 J 0 0 m 9 9 l S")
                             .line;
  EXPECT_EQ(line.width, 2);
  EXPECT_EQ(line.cap, LineCap::square);
  EXPECT_EQ(line.join, LineJoin::miter);
  EXPECT_EQ(line.miter_limit, 10);
  EXPECT_TRUE(line.dashes.empty());
  std::string dashes;
  for (int n = 0; n < 1001; ++n) dashes += "1 ";
  EXPECT_TRUE(stroked_by("[" + dashes + "] 0 d 0 0 m 9 9 l S").line.dashes.empty());
  for (const std::string path : {"", "h", "5 5 l", "1 1 m", "0 0 m 99999999 9 l"})
    EXPECT_TRUE(painted_by("/Pattern CS /p SCN " + path + " S").painted.empty()) << path;
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

std::string deflated(const std::string& text) {
  std::string packed;
  Pl_String end("packed", nullptr, packed);
  Pl_Flate deflate("deflate", &end, Pl_Flate::a_deflate);
  deflate.write(reinterpret_cast<const unsigned char*>(text.data()), text.size());
  deflate.finish();
  return packed;
}

/// Packs a text in blocks of so many bytes; `begins` gets where each begins.
std::string packed_by_zstandard(const std::string& text, std::size_t block,
                                std::vector<std::size_t>& begins) {
  std::string packed(2 * text.size(), '\0');
  ZSTD_outBuffer out{packed.data(), packed.size(), 0};
  const std::unique_ptr<ZSTD_CCtx, decltype(&ZSTD_freeCCtx)> context(ZSTD_createCCtx(),
                                                                     ZSTD_freeCCtx);
  for (std::size_t at = 0; at < text.size(); at += block) {
    begins.push_back(out.pos);
    ZSTD_inBuffer in{text.data() + at, std::min(block, text.size() - at), 0};
    const bool is_last = at + block >= text.size();
    EXPECT_EQ(ZSTD_compressStream2(context.get(), &out, &in, is_last ? ZSTD_e_end : ZSTD_e_flush),
              0U);
  }
  packed.resize(out.pos);
  return packed;
}

/// What is kept beside a page that paints a mesh, in these streams, which are named the other way
/// around.
std::string kept_beside(const std::vector<std::string>& data) {
  std::vector<std::string> streams{square_shading()};
  std::string names;
  for (std::size_t n = data.size(); n-- > 0;) {
    streams.push_back(pdf_stream("", data[n]));
    names += " /AIPrivateData" + std::to_string(n + 9) + " " + std::to_string(4 + streams.size()) +
             " 0 R";
  }
  return page_of(pdf_document(std::string(page_entries) +
                                  " /PieceInfo << /Illustrator << /Private <<" + names +
                                  " /AIMetaData 5 0 R >> >> >>",
                              "/sh sh", streams))
      .private_data;
}

TEST(PdfPage, HasWhatIllustratorKeepsBesideIt) {
  EXPECT_EQ(kept_beside({"one ", "two ", "three"}), "one two three");
  const std::string packed = deflated("of the artist");
  EXPECT_EQ(
      kept_beside({"%!PS-Adobe %AI12_CompressedData" + packed.substr(0, 5), packed.substr(5)}),
      "of the artist");
  // What is damaged is there as far as it goes.
  EXPECT_NO_THROW(kept_beside({"%AI12_CompressedData" + packed.substr(0, 5)}));
  EXPECT_EQ(kept_beside({}), "");
}

TEST(PdfPage, HasWhatIllustrator2020Keeps) {
  std::mt19937 random(49);
  std::string text;
  while (text.size() < 300000) text += static_cast<char>('a' + random() % 16);
  std::vector<std::size_t> begins;
  const std::string marker = "%!PS-Adobe %AI24_ZStandard_Data";
  const std::string packed = packed_by_zstandard(text, 20000, begins);
  // Zeros fill the last of its streams.
  EXPECT_TRUE(kept_beside({marker + packed.substr(0, 65536),
                           packed.substr(65536) + std::string(99, '\0')}) == text);
  // What is damaged is there as far as it goes: where it ends, and where a block is of no kind.
  const std::string part = kept_beside({marker + packed.substr(0, begins[7])});
  EXPECT_TRUE(part == text.substr(0, 140000)) << part.size();
  std::string broken = packed;
  broken[begins[7]] = '\x07';
  const std::string before = kept_beside({marker + broken});
  EXPECT_GT(before.size(), 130000U);
  EXPECT_TRUE(before == text.substr(0, before.size()));
  EXPECT_EQ(kept_beside({marker}), "");
  EXPECT_EQ(kept_beside({marker + "no frame"}), "");
}

TEST(PdfFile, SaysWhyItCannotBeOpened) {
  for (const std::string bytes : {"", "%PDF-1.7\n", "words", "\x1f\x8b"}) try {
      PdfFile(bytes, "a.pdf", "");
      ADD_FAILURE() << bytes;
    } catch (const InputError& error) {
      EXPECT_STREQ(error.what(), "a.pdf is damaged: none of its pages can be read.");
    }
}

}  // namespace
}  // namespace gradmesh
