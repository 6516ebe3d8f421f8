// Meshes of pages that are put into documents.
#include "app/pages/insert_pages.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "app/document/svg_document.h"
#include "app/pages/read_document.h"
#include "complaint.h"
#include "mesh/boundary.h"
#include "pdf_shadings.h"

using namespace gradmesh;
using test::complaint;

namespace {

/// A file of pages of 150 x 75 points, each with the square of 9 points as often as it says, side
/// by side from the lower left on.
class InsertPages : public testing::Test {
 protected:
  void write(const std::vector<int>& counts) {
    std::vector<PdfPageText> pages;
    for (const int count : counts) {
      std::string content;
      for (int n = 0; n < count; ++n) content += "/sh sh 1 0 0 1 20 0 cm ";
      pages.push_back({"/MediaBox [0 0 150 75] /Resources << /Shading << /sh " +
                           std::to_string(3 + 2 * counts.size()) + " 0 R >> >>",
                       content});
    }
    std::ofstream(path_, std::ios::binary) << pdf_document(pages, {square_shading()});
  }
  void TearDown() override { std::filesystem::remove(path_); }

  static std::unique_ptr<Document> svg(const std::string& attributes,
                                       const std::string& inside = "") {
    return parse_document(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" "
        "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" " +
            attributes + ">" + inside + "</svg>",
        "a.svg");
  }

  FoundPages insert(Document& document, const PageChoice& choice = {},
                    const std::string& into = "") const {
    return insert_pages(document, path_, {choice, into}).found;
  }

  /// Where the object with this id is seen, in pixels of the document.
  static Box seen(const Document& document, const std::string& id) {
    const MeshEntry entry = document.selected({id}).front();
    const SvgDocument::Place place = dynamic_cast<const SvgDocument&>(document).place(entry);
    return bounding_box(document.mesh(entry), place.to_page * place.to_user);
  }
  static void expect_box(const Box& box, glm::dvec2 low, glm::dvec2 high) {
    EXPECT_NEAR(box.low().x, low.x, 1e-6);
    EXPECT_NEAR(box.low().y, low.y, 1e-6);
    EXPECT_NEAR(box.high().x, high.x, 1e-6);
    EXPECT_NEAR(box.high().y, high.y, 1e-6);
  }

  std::filesystem::path path_ =
      std::filesystem::path(testing::TempDir()) /
      (std::string("insert_") + testing::UnitTest::GetInstance()->current_test_info()->name() +
       ".pdf");
};

TEST_F(InsertPages, puts_them_where_they_are_on_the_page) {
  write({2});
  // Units of millimetres, as Inkscape's own documents have them.
  const auto document = svg("width=\"100mm\" height=\"50mm\" viewBox=\"0 0 100 50\"");
  const FoundPages found = insert(*document);
  ASSERT_EQ(found.meshes.size(), 2U);
  expect_box(seen(*document, "page-1-mesh-1"), {0, 88}, {12, 100});
  expect_box(seen(*document, "page-1-mesh-2"), {20 / .75, 88}, {12 + 20 / .75, 100});
  const std::string text = document->bytes();
  EXPECT_NE(text.find("inkscape:groupmode=\"layer\""), text.npos);
  EXPECT_NE(text.find("inkscape:label=\"" + path_.filename().string() + '"'), text.npos);
}

TEST_F(InsertPages, puts_them_into_a_group) {
  write({1});
  const auto document =
      svg("width=\"150\" height=\"100\"",
          "<g id=\"own\" transform=\"translate(7 5) scale(2)\"><path id=\"p\"/></g>");
  insert(*document, {}, "own");
  expect_box(seen(*document, "page-1-mesh-1"), {0, 88}, {12, 100});
  const std::string text = document->bytes();
  EXPECT_EQ(text.find("groupmode"), text.npos);
  EXPECT_LT(text.find("id=\"p\""), text.find("id=\"page-1-mesh-1\""));
  EXPECT_LT(text.find("id=\"page-1-mesh-1\""), text.find("</g>"));
}

TEST_F(InsertPages, keeps_the_ellipse_of_a_stroke_and_the_groups_of_a_page) {
  const std::string form =
      "/Type /XObject /Subtype /Form /BBox [0 0 90 90] /Group << /S /Transparency >>";
  const std::string entries =
      "/MediaBox [0 0 150 75] /Resources << /Shading << /sh 5 0 R >> /Pattern << /p << "
      "/PatternType "
      "2 /Shading 5 0 R >> >> /XObject << /x 6 0 R >> /ExtGState << /half << /ca 0.5 >> >> >>";
  std::ofstream(path_, std::ios::binary)
      << pdf_document(entries, "q /Pattern CS /p SCN 4 0 0 1 0 0 cm 0 4 m 2 4 l S Q /half gs /x Do",
                      {square_shading(), pdf_stream(form, "/sh sh /sh sh")});
  const auto document =
      svg("width=\"150\" height=\"100\"", "<g id=\"own\" transform=\"translate(7 5) scale(2)\"/>");
  insert(*document, {}, "own");
  for (const char* id : {"page-1-mesh-1", "page-1-mesh-2", "page-1-mesh-3"})
    expect_box(seen(*document, id), {0, 88}, {12, 100});
  const std::string text = document->bytes();
  const std::size_t group = text.find("<g style=\"opacity:0.5\">");
  ASSERT_NE(group, text.npos);
  EXPECT_LT(text.find("id=\"page-1-mesh-1\""), group);
  EXPECT_LT(group, text.find("id=\"page-1-mesh-2\""));
}

TEST_F(InsertPages, gives_ids_that_are_free) {
  write({1});
  const auto document = svg("width=\"150\" height=\"100\"");
  EXPECT_EQ(insert(*document).meshes.at(0).id, "page-1-mesh-1");
  EXPECT_EQ(insert(*document).meshes.at(0).id, "page-1-mesh-1-2");
  EXPECT_EQ(document->meshes().size(), 2U);
}

TEST_F(InsertPages, lays_pages_on_those_of_the_document) {
  write({1, 1, 1});
  const std::string pages =
      "<inkscape:page x=\"0\" y=\"0\" width=\"150\" height=\"100\"/>"
      "<inkscape:page x=\"30\" y=\"400\" width=\"150\" height=\"100\"/>";
  const auto document = svg("width=\"150\" height=\"100\"", pages);
  insert(*document);
  expect_box(seen(*document, "page-1-mesh-1"), {0, 88}, {12, 100});
  expect_box(seen(*document, "page-2-mesh-1"), {30, 488}, {42, 500});
  // There is no third one: it lies beside as if pages lay in a row.
  expect_box(seen(*document, "page-3-mesh-1"), {440, 88}, {452, 100});
  const auto other = svg("width=\"150\" height=\"100\"");
  insert(*other, {.page = 3});
  expect_box(seen(*other, "page-3-mesh-1"), {0, 88}, {12, 100});
}

/// Tiles of the square of 12 pixels at the lower left, `count` along each side, in the colours that
/// the mesh has in their upper left corners, as Inkscape's import makes them.
std::string tiles(int count, double size = 12) {
  std::string text;
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < count; ++j) {
      const double right = double(j) / count, up = 1 - double(i) / count;
      // Red at the lower left, then clockwise green, blue and white.
      const double red = (1 - right) * (1 - up) + right * (1 - up),
                   green = (1 - right) * up + right * (1 - up),
                   blue = right * up + right * (1 - up);
      const auto level = [](double share) { return std::to_string(std::lround(255 * share)); };
      const double side = size / count;
      text += "<path d=\"M" + std::to_string(j * side) + "," + std::to_string(88 + i * side) + "h" +
              std::to_string(side) + "v" + std::to_string(side) + "h-" + std::to_string(side) +
              "z\" style=\"fill:rgb(" + level(red) + "," + level(green) + "," + level(blue) +
              ")\"/>";
    }
  return text;
}

TEST_F(InsertPages, take_the_place_of_tiles) {
  write({2});
  const std::string before =
      "<defs><clipPath id=\"own\"><path d=\"M0,0h99v99z\"/></clipPath>"
      "<clipPath id=\"used\"><path d=\"M0,0h99v99z\"/></clipPath></defs>";
  const auto document =
      svg("width=\"150\" height=\"100\"",
          before +
              "<g id=\"all\" transform=\"translate(5)\"><path id=\"below\"/>"
              "<g id=\"outer\" clip-path=\"url(#own)\"><g/><g id=\"inner\" "
              "clip-path=\"url(#used)\" transform=\"translate(-5)\">" +
              tiles(8) + "</g></g><path id=\"above\" clip-path=\"url(#used)\"/></g>");
  const InsertedPages inserted = insert_pages(*document, path_);
  EXPECT_EQ(inserted.replaced, 1);
  expect_box(seen(*document, "page-1-mesh-1"), {0, 88}, {12, 100});
  expect_box(seen(*document, "page-1-mesh-2"), {20 / .75, 88}, {12 + 20 / .75, 100});
  const std::string text = document->bytes();
  EXPECT_LT(text.find("id=\"below\""), text.find("id=\"page-1-mesh-1\""));
  EXPECT_LT(text.find("id=\"page-1-mesh-1\""), text.find("id=\"above\""));
  EXPECT_LT(text.find("id=\"above\""), text.find("id=\"page-1-mesh-2\""));
  for (const char* gone : {"\"outer\"", "\"inner\"", "\"own\""})
    EXPECT_EQ(text.find(gone), text.npos) << gone;
  EXPECT_NE(text.find("<clipPath id=\"used\""), text.npos);
}

TEST_F(InsertPages, take_the_place_of_tiles_among_other_paths) {
  write({1});
  // As the import of Inkscape 1.4 has them: beside all else of the page, each with a clip path.
  std::string own = tiles(8);
  for (std::size_t at = 0; (at = own.find("<path", at)) != own.npos; at += 5)
    own.insert(at + 5, " clip-path=\"url(#clip)\"");
  const std::string
      below = "<path id=\"below\" d=\"M0,0h150v100h-150z\" style=\"fill:#fff\"/>",
      blob = "<path id=\"blob\" d=\"M4,92h4v4h-4z\" style=\"fill:#123456\"/>",
      clip = "<defs><clipPath id=\"clip\"><path d=\"M0,0h99v99h-99z\"/></clipPath></defs>";
  const auto document = svg("width=\"150\" height=\"100\"",
                            clip + "<g id=\"layer\">" + below + own + blob + tiles(2, 20) + "</g>");
  EXPECT_EQ(insert_pages(*document, path_).replaced, 1);
  const std::string text = document->bytes();
  EXPECT_LT(text.find("\"below\""), text.find("\"page-1-mesh-1\""));
  EXPECT_LT(text.find("\"page-1-mesh-1\""), text.find("\"blob\""));
  EXPECT_NE(text.find(blob), text.npos);
  EXPECT_NE(text.find(tiles(2, 20)), text.npos);
  EXPECT_EQ(text.find("id=\"clip\""), text.npos);
}

TEST_F(InsertPages, take_tiles_of_another_colour_where_they_are_joined) {
  write({1});
  const auto with = [&](const std::string& other, bool is_joined) {
    std::string own = tiles(8);
    const std::size_t tile = own.find("<path", own.size() / 2), end = own.find("/>", tile) + 2;
    std::string changed = own.substr(tile, end - tile);
    if (is_joined)
      changed.replace(changed.find("rgb("),
                      changed.find(')', changed.find("rgb(")) + 1 - changed.find("rgb("), other);
    else
      changed += "<path d=\"M4.2,92.1h2v2h-2z\" style=\"fill:" + other + "\"/>";
    own.replace(tile, end - tile, changed);
    const auto document =
        svg("width=\"150\" height=\"100\"", "<g><rect width=\"9\" height=\"9\"/>" + own + "</g>");
    return insert_pages(*document, path_).replaced;
  };
  EXPECT_EQ(with("#123456", true), 1);
  // What somebody has drawn between them is not taken with them.
  EXPECT_EQ(with("#123456", false), 0);
}

TEST_F(InsertPages, leave_tiles_that_show_something_else) {
  write({1});
  std::string grey = tiles(8);
  for (std::size_t at = 0; (at = grey.find("rgb(", at)) != grey.npos; ++at)
    grey.replace(at, grey.find(')', at) - at + 1, "#888");
  std::string one_is_translucent = tiles(8);
  one_is_translucent.insert(one_is_translucent.rfind("fill:"), "fill-opacity:0.5;");
  for (const std::string& others : {tiles(8, 20), grey, one_is_translucent}) {
    const auto document = svg("width=\"150\" height=\"100\"", "<g id=\"group\">" + others + "</g>");
    EXPECT_EQ(insert_pages(*document, path_).replaced, 0);
    EXPECT_NE(document->bytes().find(others), std::string::npos);
  }
  const auto document = svg("width=\"150\" height=\"100\"", "<g id=\"group\">" + tiles(8) + "</g>");
  EXPECT_EQ(insert_pages(*document, path_, {.replace_tiles = false}).replaced, 0);
  // They go into what they replace.
  EXPECT_EQ(insert_pages(*document, path_, {.into = "group"}).replaced, 1);
  EXPECT_EQ(document->bytes().find("\"group\""), std::string::npos);
}

TEST_F(InsertPages, leaves_the_document_as_it_was_where_it_cannot) {
  write({1});
  const auto document = svg("width=\"150\" height=\"100\"", "<path id=\"p\" d=\"M0,0\"/>");
  const std::string before = document->bytes();
  EXPECT_EQ(complaint([&] { insert(*document, {}, "p"); }),
            "a.svg: it has no layer or group with the id p.");
  EXPECT_EQ(complaint([&] { insert(*document, {}, "q"); }),
            "a.svg: it has no layer or group with the id q.");
  EXPECT_EQ(complaint([&] { insert(*document, {.page = 2}); }),
            path_.string() + ": there is no page 2; it has 1.");
  std::ofstream(path_, std::ios::binary) << "<svg/>";
  EXPECT_EQ(complaint([&] { insert(*document); }), path_.string() + ": it is no PDF document.");
  EXPECT_EQ(document->bytes(), before);
}

}  // namespace
