// Documents of pages, read as SVG documents of their meshes.
#include "app/pages/page_documents.h"

#include <gtest/gtest.h>

#include "app/document/svg_document.h"
#include "app/document/write_file.h"
#include "app/pages/read_document.h"
#include "complaint.h"
#include "mesh/boundary.h"
#include "pdf_shadings.h"

using namespace gradmesh;
using test::complaint;

namespace {

/// What every page here has: `sh` and `wide` are squares of 9 and of 90 points.
std::string entries(int first_object) {
  const auto object = [&](int n) { return std::to_string(first_object + n) + " 0 R"; };
  return "/MediaBox [0 0 150 75] /Resources << /Shading << /sh " + object(0) + " /boxed " +
         object(1) + " /broken " + object(2) + " >> /Pattern << /p << /PatternType 2 /Shading " +
         object(0) + " >> >> /XObject << /two " + object(3) +
         " >> /ExtGState << /half << /ca 0.5 >> /screen << /BM [/Strange /Screen] >> /hard << /BM "
         "/HardLight >> >> >>";
}

std::vector<std::string> objects() {
  const std::string square = square_shading();
  std::string boxed = square, broken = square;
  boxed.insert(2, " /BBox [0 0 9 4.5]");
  broken.replace(broken.find("/BitsPerFlag 8"), 14, "/BitsPerFlag 3");
  const std::string both = "/sh sh q 0 0 m 9 0 l 0 9 l h W n /sh sh Q";
  return {
      square, boxed, broken,
      pdf_stream("/Type /XObject /Subtype /Form /BBox [0 0 90 90] /Group << /S /Transparency >>",
                 both)};
}

std::unique_ptr<Document> read(const std::vector<std::string>& contents,
                               const PageChoice& choice = {}) {
  std::vector<PdfPageText> pages;
  for (const std::string& content : contents)
    pages.push_back({entries(3 + 2 * int(contents.size())), content});
  return parse_document(pdf_document(pages, objects()), "a.pdf", choice);
}

std::vector<std::string> ids_of(const Document& document) {
  std::vector<std::string> ids;
  for (const MeshEntry& entry : document.meshes()) ids.push_back(entry.id);
  return ids;
}

/// The `d` of the object with this id.
std::string path_of(const Document& document, const std::string& id) {
  const std::string text = document.bytes();
  const std::size_t object =
      text.find("<path d=\"", text.rfind('<', text.find("id=\"" + id + '"')));
  const std::size_t begin = object + 9;
  return text.substr(begin, text.find('"', begin) - begin);
}

TEST(PageDocuments, become_svg_in_pixels) {
  const auto document = read({"/sh sh"});
  EXPECT_EQ(ids_of(*document), std::vector<std::string>{"page-1-mesh-1"});
  EXPECT_EQ(document->format().name, "svg");
  EXPECT_NE(document->bytes().find("width=\"200\" height=\"100\" viewBox=\"0 0 200 100\""),
            std::string::npos);
  // The square of 9 points at the lower left.
  const Box box = bounding_box(document->mesh(document->meshes()[0]), {});
  EXPECT_EQ(box.low(), glm::dvec2(0, 88));
  EXPECT_EQ(box.high(), glm::dvec2(12, 100));
  ASSERT_TRUE(document->pages());
  const FoundMesh& found = document->pages()->meshes.at(0);
  EXPECT_EQ(std::tuple(found.page, found.number, found.type, found.patches),
            std::tuple(1, 1, 7, 1));
  EXPECT_EQ(std::pair(found.rows, found.columns), std::pair(1, 1));
  EXPECT_FALSE(found.is_joined);
  EXPECT_LT(found.difference, 1e-6);
}

TEST(PageDocuments, lie_beside_one_another_in_layers) {
  const auto document = read({"/sh sh", "n", "/sh sh 2 0 0 2 0 0 cm /sh sh"});
  EXPECT_EQ(ids_of(*document),
            (std::vector<std::string>{"page-1-mesh-1", "page-3-mesh-1", "page-3-mesh-2"}));
  const std::string text = document->bytes();
  EXPECT_NE(text.find("inkscape:label=\"Page 1\""), std::string::npos);
  EXPECT_EQ(text.find("inkscape:label=\"Page 2\""), std::string::npos);
  EXPECT_NE(text.find("<inkscape:page x=\"220\" y=\"0\" width=\"200\" height=\"100\"/>"),
            std::string::npos);
  const MeshEntry& entry = document->meshes()[1];
  EXPECT_EQ(document->view(entry).point({12, 100}), glm::dvec2(232, 100));
}

TEST(PageDocuments, are_read_one_page_at_a_time_as_well) {
  const auto document = read({"/sh sh", "/sh sh /sh sh"}, {.page = 2});
  EXPECT_EQ(ids_of(*document), (std::vector<std::string>{"page-2-mesh-1", "page-2-mesh-2"}));
  EXPECT_EQ(document->bytes().find("inkscape:page"), std::string::npos);
  EXPECT_EQ(complaint([] { read({"/sh sh"}, {.page = 2}); }),
            "a.pdf: there is no page 2; it has 1.");
  EXPECT_EQ(complaint([] {
              read_document(GRADMESH_SOURCE_DIR "/samples/two.svg", PageChoice{.page = 1});
            }),
            GRADMESH_SOURCE_DIR "/samples/two.svg: it has no pages to choose from.");
}

TEST(PageDocuments, have_the_shapes_that_are_seen) {
  const std::string clip = "q 0 0 m 9 0 l 0 9 l h W n /sh sh Q";
  const auto document = read({"/sh sh q -1 -1 90 90 re W n /sh sh Q " + clip + " /boxed sh"});
  const std::string own = path_of(*document, "page-1-mesh-1");
  // A box around all of it hides nothing.
  EXPECT_EQ(path_of(*document, "page-1-mesh-2"), own);
  EXPECT_EQ(path_of(*document, "page-1-mesh-3"), "M0,100 L12,100 L0,88 Z");
  EXPECT_EQ(path_of(*document, "page-1-mesh-4"), "M0,100 L12,100 L12,94 L0,94 Z");
}

TEST(PageDocuments, are_seen_through_several_clips) {
  const auto document =
      read({"0 0 m 9 0 l 0 9 l h W n 0 0 m 9 0 l 9 9 l h W* n 0 0 m 9 9 l 0 9 l h W n /sh sh"});
  const MeshEntry entry = document->meshes().at(0);
  const auto area = document->visible_area(entry);
  ASSERT_TRUE(area);
  EXPECT_EQ(area->sets.size(), 3U);
  EXPECT_EQ(path_of(*document, entry.id), "M0,100 L12,88 L0,88 Z");
}

TEST(PageDocuments, are_mixed_with_what_lies_below) {
  const std::string text = read({"/sh sh q /hard gs /sh sh Q q 0 0 m 9 0 l 0 9 l h W n 0 0 m 9 9 l "
                                 "0 9 l h W n /screen gs "
                                 "/sh sh Q"})
                               ->bytes();
  std::size_t count = 0;
  for (std::size_t at = text.find("mix-blend"); at != text.npos;
       at = text.find("mix-blend", at + 1))
    ++count;
  EXPECT_EQ(count, 2U);
  EXPECT_NE(text.find("mix-blend-mode:hard-light"), std::string::npos);
  // Of what is clipped the outermost group is.
  const std::size_t group = text.find("<g clip-path");
  ASSERT_NE(group, text.npos);
  EXPECT_LT(text.find("mix-blend-mode:screen"), text.find('>', group));
}

TEST(PageDocuments, are_mixed_as_a_group_where_the_page_has_one) {
  const std::string text =
      read({"/sh sh q /half gs /screen gs /two Do Q q /half gs /two Do Q /sh sh"})->bytes();
  const std::size_t first = text.find("<g style=\"mix-blend-mode:screen;opacity:0.5\">"),
                    second = text.find("<g style=\"opacity:0.5\">");
  ASSERT_NE(first, text.npos);
  ASSERT_NE(second, text.npos);
  const auto place = [&](const char* id) { return text.find('"' + std::string(id) + '"', 0); };
  EXPECT_LT(place("page-1-mesh-1"), first);
  EXPECT_LT(first, place("page-1-mesh-2"));
  EXPECT_LT(place("page-1-mesh-3"), second);
  EXPECT_LT(second, place("page-1-mesh-4"));
  EXPECT_EQ(text.find("opacity:0.5", second + 20), text.npos);
}

TEST(PageDocuments, have_strokes_that_are_wider_in_one_direction) {
  const auto document = read({"/Pattern CS /p SCN q 4 0 0 1 0 0 cm 1 w 0 4 m 2 4 l S Q"});
  const std::string text = document->bytes();
  EXPECT_NE(text.find("transform=\"matrix(2 0 0 0.5 0 0)\""), std::string::npos);
  EXPECT_NE(text.find("stroke-width:2.6666"), std::string::npos);
  // In the coordinates of the pen, in which the mesh is, too.
  EXPECT_EQ(path_of(*document, "page-1-mesh-1"), "M0,189.333333 L5.33333333,189.333333");
  const Box mesh = bounding_box(document->mesh(document->meshes().at(0)), {});
  EXPECT_NEAR(mesh.high().x, 6, 1e-4);
  EXPECT_NEAR(mesh.low().y, 176, 1e-3);
}

TEST(PageDocuments, tell_what_is_left_out) {
  const auto document = read({"/broken sh /sh sh q 50 50 9 9 re W n /sh sh Q"});
  EXPECT_EQ(ids_of(*document), std::vector<std::string>{"page-1-mesh-2"});
  std::vector<std::string> sentences;
  for (const Message& sentence : document->pages()->left_out)
    sentences.push_back(sentence.english());
  EXPECT_EQ(sentences,
            (std::vector<std::string>{"a.pdf, page 1, mesh 1: a shading's flags have 3 bits.",
                                      "a.pdf, page 1, mesh 3: its clip path hides it."}));
  EXPECT_EQ(complaint([] { read({"n"}); }), "a.pdf: there is no gradient mesh on its pages.");
  EXPECT_EQ(complaint([] { read({"q 50 50 9 9 re W n /sh sh Q"}); }),
            "a.pdf, page 1, mesh 1: its clip path hides it.");
}

TEST(PageDocuments, are_known_by_their_content) {
  EXPECT_TRUE(holds_pages("%PDF-1.4\n"));
  EXPECT_TRUE(holds_pages("junk before it\n%PDF-1.4\n"));
  EXPECT_FALSE(holds_pages("\n<?xml version='1.0'?><!-- of a %PDF-1.4 --><svg/>"));
  EXPECT_FALSE(holds_pages("HEMESH"));
  EXPECT_FALSE(holds_pages(std::string(2000, ' ') + "%PDF-1.4\n"));
}

TEST(PageDocuments, are_not_written) {
  const auto document = read({"/sh sh"});
  for (const char* name : {"b.pdf", "b.ai", "B.PDF"})
    EXPECT_EQ(complaint([&] { check_target(*document, name); }),
              std::string(name) +
                  ": such documents are only read; write an SVG document or a .hemesh file.");
  check_target(*document, "b.svg");
}

}  // namespace
