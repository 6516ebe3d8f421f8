// Style sheets are read as Inkscape 1.2.2 reads them: each line here was tried with it.
#include <gtest/gtest.h>

#include "formats/svg/tree/paint.h"
#include "formats/svg/tree/svg_tree.h"
#include "formats/svg/tree/unused.h"
#include "formats/svg/values/rules.h"
#include "formats/svg/values/selector.h"
#include "formats/svg/xml/node.h"

namespace gradmesh {
namespace {

SvgTree with_body(const std::string& body) {
  return SvgTree::parse("<svg xmlns='http://www.w3.org/2000/svg'>" + body + "</svg>", "test");
}

const std::string family =
    "<g id='g' class='c'><defs/><!-- --> text <rect id='r' class='a b' k='v-w' l='u v'/>"
    "<g id='h'><rect id='s' class='a'/></g><path id='p'/></g>";

/// Returns the ids of the elements that some of the selectors match.
std::string matched(const std::string& selectors, const SvgTree& tree) {
  std::string ids;
  for (const xmlNode* node : elements_from(tree.root()))
    for (const Selector& selector : parse_selectors(selectors))
      if (selector.matches(node)) {
        ids += (ids.empty() ? "" : " ") + attribute(node, "id").value_or("-");
        break;
      }
  return ids;
}

TEST(SvgSelectors, match_as_inkscape_matches_them) {
  const SvgTree tree = with_body(family);
  const std::pair<const char*, const char*> cases[] = {
      {"rect", "r s"},
      {"RECT", ""},
      {".a", "r s"},
      {".A", ""},
      {".a.b", "r"},
      {"rect.a#s", "s"},
      {"*.a", "r s"},
      {"#h *", "s"},
      {"#g rect", "r s"},
      {"#g > rect", "r"},
      {"#g>g>rect", "s"},
      {".c .a", "r s"},
      {"svg > g > .b", "r"},
      {"#r + g", "h"},
      {"#r + path", ""},
      {"#r ~ path", "p"},
      {"#p ~ rect", ""},
      {"#g > g rect", "s"},
      {"[k]", "r"},
      {"rect[k=\"v-w\"]", "r"},
      {"rect[ k = 'v-w' ]", "r"},
      {"[k=v]", ""},
      {"[k|=v]", "r"},
      {"[l~=v]", "r"},
      {"[l~=u][k]", "r"},
      {"[l~=w]", ""},
      {":root", "-"},
      {":root .b", "r"},
      {"rect:first-child", "s"},
      {"#g path:last-child", "p"},
      {"rect:only-child", "s"},
      {"#g > rect:nth-child(2)", "r"},
      {"#g > *:nth-child(2n + 1)", "- h"},
      {"#g > *:nth-child(even)", "r p"},
      {"#g > *:nth-child(-n+2)", "- r"},
      {"#g > *:nth-last-child(1)", "p"},
      {"#g rect:nth-of-type(1)", "r s"},
      {"#g > g:first-of-type", "h"},
      {"rect:empty", "r s"},
      {"g:empty", ""},
      {"rect:hover, path", "p"},
      {"rect:FIRST-CHILD", ""},
      {".z ,\n.b", "r"},
      {".\\61 ", "r s"},
      // A blank behind an element's name does not count.
      {"rect .b", "r"},
      {"g #r", ""},
      {"#g rect .b", "r"},
      // One selector that is not read takes all of the rule away.
      {"rect:not(.x)", ""},
      {".b, rect::before", ""},
      {".b, [k^=v]", ""},
      {".b, [k=v i]", ""},
      {".b, svg|rect", ""},
      {".b, .1", ""},
      {".b, ._a", ""},
      {".b, ", ""},
      {".b > > rect", ""},
      {"> .b", ""},
      {"", ""},
  };
  for (const auto& [selectors, ids] : cases) EXPECT_EQ(matched(selectors, tree), ids) << selectors;
}

TEST(SvgSelectors, escapes_are_those_that_inkscape_reads) {
  const auto matches = [](const std::string& selector, const std::string& id) {
    SvgTree tree = with_body("<rect/>");
    xmlNode* const rect = child_elements(tree.root(), "rect").at(0);
    set_attribute(rect, "id", id);
    return matched(selector, tree) == id;
  };
  const std::pair<const char*, const char*> read[] = {{"#a\\ b", "a b"},
                                                      {"#a\\20 b", "a b"},
                                                      {"#a\\2e b", "a.b"},
                                                      {"#\\31 a", "1a"},
                                                      {"#a\\e9 b",
                                                       "a\xc3\xa9"
                                                       "b"},
                                                      {"#a\\20ac b",
                                                       "a\xe2\x82\xac"
                                                       "b"},
                                                      {"#a\\1f600 b",
                                                       "a\xf0\x9f\x98\x80"
                                                       "b"},
                                                      {"#a\\\xc3\xa9z", "a\xc3\xa9z"},
                                                      {"#a\xc2\xb2z", "a\xc2\xb2z"}};
  for (const auto& [selector, id] : read) EXPECT_TRUE(matches(selector, id)) << selector;
  const std::pair<const char*, const char*> unread[] = {{"#a\\.b", "a.b"},
                                                        {"#a\\zb", "azb"},
                                                        {"#a\\\xc3\x87z", "a\xc3\x87z"},
                                                        {"#a\xc2\xb1z", "a\xc2\xb1z"},
                                                        {"#a\\0 b", "ab"}};
  for (const auto& [selector, id] : unread) EXPECT_FALSE(matches(selector, id)) << selector;
}

TEST(SvgSelectors, many_elements_around_take_no_time) {
  std::string body = "<rect id='r'/>", selector = "#r";
  for (int i = 0; i < 200; ++i) body = "<g>" + body + "</g>";
  for (int i = 0; i < 60; ++i) selector = "* " + selector;
  EXPECT_EQ(matched("path " + selector + ", path * " + selector, with_body(body)), "");
}

using Sheets = std::vector<std::string>;

/// Returns the fill of the rect, with a style sheet.
std::string fill_by(const std::string& css, const std::string& attributes = "",
                    const std::string& type = "text/css") {
  const SvgTree tree =
      with_body("<style type='" + type + "'><![CDATA[" + css +
                "]]></style><g id='g'><rect id='r' class='a b' " + attributes + "/></g>");
  return tree.styles().declared(tree.find("r"), "fill").value_or("");
}

TEST(SvgStyleSheets, what_counts_of_several_declarations) {
  EXPECT_EQ(fill_by(".a{fill:red} .b{fill:blue}"), "blue");
  EXPECT_EQ(fill_by(".a.b{fill:red} .b{fill:blue}"), "red");
  EXPECT_EQ(fill_by("rect.b{fill:red} .b{fill:blue}"), "red");
  EXPECT_EQ(fill_by("#r{fill:red} #g > .a.b.a.b{fill:blue} .a.b.a.b.a.b{fill:green}"), "blue");
  EXPECT_EQ(fill_by("rect:first-child{fill:red} rect{fill:blue}"), "red");
  EXPECT_EQ(fill_by("[class]{fill:red} .a{fill:blue}"), "blue");
  EXPECT_EQ(fill_by("#x, .a{fill:red} rect.a{fill:blue}"), "blue");
  EXPECT_EQ(fill_by(".a{fill:red !important} #r{fill:blue}"), "red");
  EXPECT_EQ(fill_by(".a{fill:red!important;fill:blue}"), "red");
  // A more specific rule before stays, an equal one does not.
  EXPECT_EQ(fill_by("#r{fill:blue} .a{fill:red!important}"), "blue");
  EXPECT_EQ(fill_by(".a{fill:blue} .a{fill:red!important} #r{fill:green}"), "red");
  EXPECT_EQ(fill_by(".a{fill:red!important} #r{fill:green!important}"), "green");
  EXPECT_EQ(fill_by(".a{fill:red}", "style='fill:blue'"), "blue");
  EXPECT_EQ(fill_by(".a{fill:red ! important}", "style='fill:blue'"), "red");
  EXPECT_EQ(fill_by(".a{fill:red !important}", "style='fill:blue !important'"), "blue");
  EXPECT_EQ(fill_by("", "style='fill:blue !important;fill:red'"), "blue");
  EXPECT_EQ(fill_by(".a{fill:red}", "fill='blue'"), "red");
  EXPECT_EQ(fill_by(".a{FILL:red}", "fill='blue'"), "blue");
  EXPECT_EQ(fill_by("", "style='FILL:red' fill='blue'"), "blue");
}

TEST(SvgStyleSheets, what_is_heeded_of_a_style_element) {
  const std::string rule = ".a{fill:red}";
  for (const std::string& css :
       Sheets{rule, "<!-- " + rule + " -->", "/* x */" + rule, "@media print{" + rule + "}",
              "@media screen, print{.z{fill:blue}" + rule + "}", "@import 'x';" + rule,
              "@media (min-width:1px){.a{fill:blue}}" + rule, "@font-face{font-family:x}" + rule,
              "@media all{" + rule + ".a:not(.x){fill:blue}}", ".a:not(.x){fill:blue}" + rule,
              ".a{fill:$x}" + rule, rule + ".a{fill:blue stroke:red}",
              rule + ".a{fill:blue !IMPORTANT}", ".a{;fill:red;;}", ".a{fill:/*x*/red}",
              ".x{}" + rule, ".x{font:\"x}" + rule, ".x{src:url(data:a/b;base64,x==)}" + rule,
              ".a{fill:red;width:calc(100% - 1px)}"})
    EXPECT_EQ(fill_by(css), "red") << css;
  EXPECT_EQ(fill_by(rule, "", "text/plain"), "red");
}

TEST(SvgStyleSheets, what_is_broken_takes_the_whole_element_away) {
  const std::string rule = ".a{fill:red}";
  for (const std::string& css :
       Sheets{rule + ".b{fill:blue", rule + "/* x", rule + " x", rule + "}", rule + ";" + rule,
              ".x{--x:1}" + rule, ".a{fill:red;x}", ".a{fill:red;x:}", ".x{*fill:blue}" + rule,
              ".x{_height:1px}" + rule, ".x{.y{fill:blue}}" + rule, ".x{fill:a)}" + rule,
              "@media all{@media print{" + rule + "}}" + rule})
    EXPECT_EQ(fill_by(css), "") << css;
  for (const std::string& css : Sheets{
           "@media (min-width:1px){" + rule + "}", "@MEDIA all{" + rule + "}",
           "@media all{.a:not(.x){fill:blue}" + rule + "}", "@supports (fill:red){" + rule + "}"})
    EXPECT_EQ(fill_by(css), "") << css;
}

TEST(SvgStyleSheets, what_is_set_wins_over_important_rules) {
  SvgTree tree = with_body("<style>.a{fill:red !important}</style><rect id='r' class='a'/>");
  xmlNode* const rect = tree.find("r");
  set_style(tree.styles(), rect, "fill", "url(#m)");
  set_style(tree.styles(), rect, "stroke", "none");
  EXPECT_EQ(tree.styles().declared(rect, "fill"), "url(#m)");
  EXPECT_EQ(attribute(rect, "style"), "fill:url(#m) !important;stroke:none");
  EXPECT_EQ(take_style(rect, "fill"), "url(#m)");
}

TEST(SvgStyleSheets, what_rules_said_of_an_element_stays_where_it_moves) {
  SvgTree tree = with_body(
      "<style>svg > .a{stroke:blue;stroke-width:8} .a{fill:red}</style><rect id='r' class='a'/>");
  xmlNode* const rect = tree.find("r");
  const Declarations said = said_by_rules(tree.styles(), rect);
  xmlNode* const group = add_child(tree.root(), "g");
  xmlUnlinkNode(rect);
  xmlAddChild(group, rect);
  EXPECT_FALSE(tree.styles().declared(rect, "stroke"));
  keep_said(tree.styles(), said, rect);
  EXPECT_EQ(attribute(rect, "style"), "stroke:blue;stroke-width:8");
}

TEST(SvgStyleSheets, a_rule_uses_what_some_element_has_of_it) {
  SvgTree tree = with_body(
      "<style>.a{fill:url(#m)} .z{fill:url(#n)} .a:not(.b){fill:url(#o)} #q stop{fill:red}</style>"
      "<rect id='r' class='a'/>");
  EXPECT_TRUE(is_used(tree, "m"));
  EXPECT_FALSE(is_used(tree, "n"));
  EXPECT_TRUE(is_used(tree, "o"));
  EXPECT_FALSE(is_used(tree, "q"));
  set_style(tree.styles(), tree.find("r"), "fill", "blue");
  EXPECT_FALSE(is_used(tree, "m"));
}

}  // namespace
}  // namespace gradmesh
