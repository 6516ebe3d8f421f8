// Links of a document that is written into another folder lead to the same files.
#include <gtest/gtest.h>

#include <random>

#include "formats/svg/tree/move_links.h"
#include "formats/svg/values/moved_css.h"
#include "formats/svg/values/reference.h"
#include "svg_documents.h"

namespace gradmesh::test {
namespace {

namespace fs = std::filesystem;

const FolderMove beside{"/drawings/a/drawing.svg", "/drawings/b"};

std::string moved(std::string_view link, const FolderMove& move = beside) {
  return moved_link(link, move).value_or("(stays)");
}

TEST(MovedLink, leads_to_the_same_file) {
  EXPECT_EQ(moved("photo.png"), "../a/photo.png");
  EXPECT_EQ(moved("./photo.png"), "../a/photo.png");
  EXPECT_EQ(moved("pics/photo.png"), "../a/pics/photo.png");
  EXPECT_EQ(moved("../photo.png"), "(stays)");
  EXPECT_EQ(moved("../b/photo.png"), "photo.png");
  EXPECT_EQ(moved("../../photo.png"), "(stays)");
  EXPECT_EQ(moved("stars.svg#star"), "../a/stars.svg#star");
  EXPECT_EQ(moved("photo.png?a/b#c/d"), "../a/photo.png?a/b#c/d");
  EXPECT_EQ(moved(" photo.png\n"), "../a/photo.png");
  EXPECT_EQ(moved("pics/"), "../a/pics/");
  EXPECT_EQ(moved("photo.png", {"/drawing.svg", "/made/of"}), "../../photo.png");
  EXPECT_EQ(moved("made/of/photo.png", {"/drawing.svg", "/made/of"}), "photo.png");
  EXPECT_EQ(moved("photo.png", {"/made/of/drawing.svg", "/"}), "made/of/photo.png");
  // Above the root is the root.
  EXPECT_EQ(moved("../../../../../photo.png"), "../../photo.png");
}

TEST(MovedLink, stays_where_no_folder_counts) {
  for (const std::string_view link :
       {"", " ", "#star", " #star", "?query", "/photo.png", "//host/photo.png",
        "data:image/png;base64,AA", "\ndata:,a", "http://host/photo.png", "HTTPS://host",
        "file:///photo.png", "file:photo.png", "C:/photo.png", "c:\\photo.png",
        "\\\\host\\photo.png", "\\photo.png", "urn:x"})
    EXPECT_EQ(moved(link), "(stays)") << link;
}

TEST(MovedLink, keeps_its_spelling) {
  EXPECT_EQ(moved("my%20photo.png"), "../a/my%20photo.png");
  EXPECT_EQ(moved("my photo.png"), "../a/my photo.png");
  EXPECT_EQ(moved("b\xc3\xa4r.png"), "../a/b\xc3\xa4r.png");
  EXPECT_EQ(moved("50%.png"), "../a/50%.png");
  EXPECT_EQ(moved("pics\\photo.png"), "../a/pics\\photo.png");
  EXPECT_EQ(moved("\xc3\xa4:b.png"), "../a/\xc3\xa4:b.png");
}

TEST(MovedLink, encodes_the_names_of_folders) {
  EXPECT_EQ(moved("p.png", {"/x/my #1 (50%)/d.svg", "/x/b"}), "../my%20%231%20%2850%25%29/p.png");
  EXPECT_EQ(moved("p.png", {fs::path(u8"/x/Bäume/d.svg"), "/x/b"}), "../B%C3%A4ume/p.png");
  EXPECT_EQ(moved("p.png", {"/x/c:d/d.svg", "/x"}), "c%3Ad/p.png");
  // Where it is spelled otherwise, it is the same folder.
  EXPECT_EQ(moved("../my%20pics/p.png", {"/x/a/d.svg", "/x/my pics"}), "p.png");
  EXPECT_EQ(moved("../my pics/p.png", {"/x/a/d.svg", "/x/my pics"}), "p.png");
  // What was behind a folder would begin an address with a scheme, or with the root.
  EXPECT_EQ(moved("../b/c:d.png"), "./c:d.png");
  EXPECT_EQ(moved("../b//p.png"), ".//p.png");
  EXPECT_EQ(moved("../b/"), "./");
}

TEST(MovedLink, into_the_document_itself_needs_no_file) {
  EXPECT_EQ(moved("drawing.svg#star"), "#star");
  EXPECT_EQ(moved("../a/drawing%2Esvg#star"), "#star");
  EXPECT_EQ(moved("drawing.svg"), "../a/drawing.svg");
  EXPECT_EQ(moved("drawing.svg#"), "../a/drawing.svg#");
}

#ifdef _WIN32
TEST(MovedLink, to_another_drive_is_absolute) {
  EXPECT_EQ(moved("my photo.png", {"C:\\a\\d.svg", "D:\\b"}), "file:///C:/a/my photo.png");
}
#endif

/// A folder of up to four names, some of which are alike.
fs::path any_folder(std::mt19937& random) {
  const std::vector<std::u8string> names{u8"a", u8"b", u8"my pics", u8"50% #1", u8"Bäume", u8"c;d"};
  fs::path folder = "/";
  for (auto count = random() % 5; count > 0; --count) folder /= names[random() % names.size()];
  return folder;
}

/// A link below a folder, beside it or above it.
std::string any_link(std::mt19937& random) {
  const std::vector<std::string> parts{"a", "b", "my%20pics", "my pics", "..", ".", "..", "Bäume"};
  std::string link;
  for (auto count = random() % 5; count > 0; --count) link += parts[random() % parts.size()] + "/";
  return link + "photo.png";
}

fs::path place_of(const fs::path& folder, std::string_view link) {
  return (folder / fs::path(percent_decoded(link))).lexically_normal();
}

TEST(MovedLink, from_any_folder_to_any_other_and_back) {
  std::mt19937 random(1);
  for (int i = 0; i < 20000; ++i) {
    const fs::path from = any_folder(random), to = any_folder(random);
    const std::string link = any_link(random);
    SCOPED_TRACE(from.string() + " to " + to.string() + ": " + link);
    const std::string there = moved_link(link, {from / "d.svg", to}).value_or(link);
    ASSERT_EQ(place_of(to, there), place_of(from, link)) << there;
    const std::string back = moved_link(there, {to / "d.svg", from}).value_or(there);
    ASSERT_EQ(place_of(from, back), place_of(from, link)) << back;
  }
}

std::string moved_text(std::string_view css) { return moved_css(css, beside).value_or("(stays)"); }

TEST(MovedCss, has_other_addresses) {
  EXPECT_EQ(moved_text("fill:url(x.svg#a) red;stroke:none"),
            "fill:url(../a/x.svg#a) red;stroke:none");
  EXPECT_EQ(moved_text("url( \"my x.svg#a\" )"), "url( \"../a/my x.svg#a\" )");
  EXPECT_EQ(moved_text("url('x.svg#a')"), "url('../a/x.svg#a')");
  EXPECT_EQ(moved_text("URL(x.svg)"), "URL(../a/x.svg)");
  EXPECT_EQ(moved_text("a\\\"b url(x.svg)"), "a\\\"b url(../a/x.svg)");
  EXPECT_EQ(moved_text("fill:url(x.svg#a"), "fill:url(../a/x.svg#a");
  EXPECT_EQ(moved_text("src:url(a.woff),url(b.ttf)"), "src:url(../a/a.woff),url(../a/b.ttf)");
  EXPECT_EQ(moved_text("@import \"x.css\" screen;"), "@import \"../a/x.css\" screen;");
  EXPECT_EQ(moved_text("@IMPORT/**/'x.css'"), "@IMPORT/**/'../a/x.css'");
  EXPECT_EQ(moved_text("@import url(x.css);"), "@import url(../a/x.css);");
}

TEST(MovedCss, stays_where_it_names_no_file) {
  for (const std::string_view css :
       {"", "fill:red", "fill:url(#a)", "fill:url('#a')", "url()", "url(\"\")", "url(",
        "url(\"x.svg)", "url(a b(c).png)", "url(data:image/png;base64,AA)",
        "url(http://host/x.svg#a)", "my-url(x.svg)", "content:'url(x.svg)'", "/* url(x.svg) */",
        "/* @import 'x.css'", "import 'x.css'", "@media 'x.css'", "@import red 'x.css'",
        "font-family:'x.ttf'"})
    EXPECT_EQ(moved_text(css), "(stays)") << css;
}

/// What a document becomes, without the elements around its content.
std::string moved_content(const std::string& content) {
  SvgTree tree = svg_tree(content);
  const std::string before = tree.serialize();
  if (!move_links(tree, beside)) {
    EXPECT_EQ(tree.serialize(), before);
    return "(stays)";
  }
  const std::string after = tree.serialize();
  const std::size_t start = before.find(content);
  return after.substr(start, after.rfind("</svg>") - start);
}

TEST(MovedLinks, of_whatever_shows_a_file) {
  EXPECT_EQ(moved_content("<image xlink:href=\"a&amp;b.png\"/>"),
            "<image xlink:href=\"../a/a&amp;b.png\"/>");
  EXPECT_EQ(moved_content("<image href=\"p.png\" xlink:href=\"p.png\"/>"),
            "<image href=\"../a/p.png\" xlink:href=\"../a/p.png\"/>");
  EXPECT_EQ(moved_content("<use href=\"x.svg#a\"/>"), "<use href=\"../a/x.svg#a\"/>");
  EXPECT_EQ(moved_content("<filter><feImage href=\"p.png\"/></filter>"),
            "<filter><feImage href=\"../a/p.png\"/></filter>");
  EXPECT_EQ(
      moved_content(
          "<g fill=\"url(x.svg#a)\" clip-path=\"url(x.svg#b)\" style=\"mask:url(m.svg#c)\"/>"),
      "<g fill=\"url(../a/x.svg#a)\" clip-path=\"url(../a/x.svg#b)\" "
      "style=\"mask:url(../a/m.svg#c)\"/>");
  EXPECT_EQ(moved_content("<style>@import 'x.css'; g&gt;a{fill:url(x.svg#a)}</style>"),
            "<style>@import '../a/x.css'; g&gt;a{fill:url(../a/x.svg#a)}</style>");
  EXPECT_EQ(moved_content("<style><![CDATA[g>a{fill:url(x.svg#a)}]]></style>"),
            "<style><![CDATA[g>a{fill:url(../a/x.svg#a)}]]></style>");
}

TEST(MovedLinks, leave_everything_else) {
  for (const char* content :
       {"<a href=\"page.html\" xlink:href=\"page.html\"><g/></a>", "<image href=\"data:,a\"/>",
        "<use href=\"#a\"/>", "<g id=\"url(x.svg)\" inkscape:label=\"url(x.svg)\"/>",
        "<o:image xmlns:o=\"urn:other\" href=\"p.png\" style=\"fill:url(x.svg#a)\"/>",
        "<g o:href=\"p.png\" xmlns:o=\"urn:other\"/>", "<text>url(x.svg)</text>",
        "<!-- <image href=\"p.png\"/> -->", "<g xml:base=\"pics/\"><image href=\"p.png\"/></g>"})
    EXPECT_EQ(moved_content(content), "(stays)") << content;
}

TEST(MovedLinks, of_style_sheets_before_the_document_and_with_entities) {
  SvgTree tree = SvgTree::parse(
      "<?xml-stylesheet type=\"text/css\" href='x.css'?><!DOCTYPE svg [<!ENTITY red \"red\">]>"
      "<svg xmlns=\"http://www.w3.org/2000/svg\"><g style=\"fill:url(x.svg#a) &red;\"/>"
      "<image href=\"&red;.png\"/></svg>",
      drawing_name);
  EXPECT_TRUE(move_links(tree, beside));
  const std::string text = tree.serialize();
  EXPECT_NE(text.find("href='../a/x.css'"), text.npos) << text;
  EXPECT_NE(text.find("fill:url(../a/x.svg#a) &red;"), text.npos) << text;
  EXPECT_NE(text.find("href=\"&red;.png\""), text.npos) << text;
}

}  // namespace
}  // namespace gradmesh::test
