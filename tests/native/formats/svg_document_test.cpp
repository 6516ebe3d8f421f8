#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "files/atomic_file.h"
#include "svg_documents.h"

namespace gradmesh {
namespace {

const std::string head = "<svg xmlns=\"http://www.w3.org/2000/svg\">";
const std::string row =
    "<meshrow><meshpatch><stop path='l 1,0'/><stop path='l 0,1'/><stop path='l -1,0'/><stop "
    "path='l'/></meshpatch></meshrow>";
const std::string gradients = "<meshgradient id='m'>" + row +
                              "</meshgradient><meshgradient id='n'>" + row +
                              "</meshgradient><linearGradient id='flat'/>";

SvgTree parse(const std::string& text) { return SvgTree::parse(text, test::drawing_name); }

SvgTree parse_body(const std::string& body) { return parse(head + gradients + body + "</svg>"); }

/// `id fill=GRADIENT` of every object found, in order.
std::string listing(const std::string& body) {
  SvgTree document = parse_body(body);
  std::string text;
  for (const MeshObject& object : mesh_objects(document)) {
    const char* role = object.role == PaintRole::fill ? " fill" : " stroke";
    EXPECT_EQ(document.find(object.id), object.node);
    text += object.id + role + (object.gradient == document.find("m") ? "=m; " : "=n; ");
  }
  return text;
}

/// Returns the sentence that `action` ends in, while libxml2 says nothing itself.
std::string complaint(const std::function<void()>& action) {
  testing::internal::CaptureStderr();
  std::string message = test::complaint(action);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  return message;
}

std::string parse_complaint(const std::string& text) {
  return complaint([&] { parse(text); });
}

TEST(SvgObjects, paint_comes_from_style_attribute_or_group) {
  EXPECT_EQ(listing("<path id='a' fill='url(#m)' stroke='url(#n)'/>"), "a fill=m; a stroke=n; ");
  EXPECT_EQ(listing("<rect id='a' fill='url(#m)' style='fill:url(#n)'/>"), "a fill=n; ");
  EXPECT_EQ(listing("<rect id='a' fill='url(#m)' style='fill:red'/>"), "");
  EXPECT_EQ(listing("<g fill='url(#m)'><g><circle id='a'/><circle id='b' fill='none'/><circle "
                    "id='c' fill='inherit'/></g><text id='d'>x</text></g><circle id='e'/>"),
            "a fill=m; c fill=m; d fill=m; ");
  EXPECT_EQ(listing("<g fill='url(#m)' stroke='url(#n)'><line id='a'/></g>"), "a stroke=n; ");
  EXPECT_EQ(listing("<rect id='a' fill='url(#flat)'/><rect id='b' fill='url(#none)'/>"), "");
}

TEST(SvgObjects, writings_of_the_paint) {
  for (const std::string paint :
       {"url(#m)", "url( '#m' )", "url(#m) #abc", "url(#m) none", "url(&quot;#%6d&quot;) red"})
    EXPECT_EQ(listing("<rect id='a' fill=\"" + paint + "\"/>"), "a fill=m; ") << paint;
  // What Inkscape cannot read is as if it were not there.
  for (const std::string paint : {"URL(#n)", "foo", "None", "#ff000"})
    EXPECT_EQ(listing("<g fill='url(#m)'><rect id='a' fill='" + paint + "'/></g>"), "a fill=m; ")
        << paint;
  for (const std::string paint : {"none", "RED", "currentColor", "url(#nowhere)"})
    EXPECT_EQ(listing("<g fill='url(#m)'><rect id='a' fill='" + paint + "'/></g>"), "") << paint;
  EXPECT_EQ(listing("<rect id='a' style='; ;stroke:none;fill : url(&quot;#m&quot;) !important;'/>"),
            "a fill=m; ");
}

TEST(SvgObjects, a_text_is_painted_by_a_mesh_where_all_its_parts_are) {
  EXPECT_EQ(listing("<text id='a'><tspan fill='url(#m)'>x</tspan> <tspan style='fill:url(#m)'>y"
                    "</tspan></text>"),
            "a fill=m; ");
  EXPECT_EQ(listing("<text id='a'><textPath fill='url(#m)'>x</textPath></text>"), "a fill=m; ");
  EXPECT_EQ(listing("<text id='a' fill='url(#m)'>x<tspan>y</tspan></text>"), "a fill=m; ");
  EXPECT_EQ(listing("<text id='a' fill='url(#m)'><tspan fill='red'>y</tspan></text>"), "");
}

TEST(SvgObjects, what_cannot_be_changed_alone_is_told) {
  const auto reason = [](const std::string& body) {
    SvgTree document = parse_body(body);
    const auto objects = mesh_objects(document);
    return complaint([&] { check_can_change(objects.at(0)); });
  };
  const std::string mixed =
      "drawing.svg: text \"a\": parts of the text are painted in other ways; to change the mesh, "
      "give all of it one paint.";
  EXPECT_EQ(reason("<text id='a' fill='url(#m)'>x<tspan fill='red'>y</tspan></text>"), mixed);
  EXPECT_EQ(reason("<text id='a' fill='url(#m)'>x<tspan fill='url(#n)'>y</tspan></text>"), mixed);
  EXPECT_EQ(reason("<text id='a' fill='url(#m)'>x<tspan fill-opacity='0.5'>y</tspan></text>"),
            mixed);
  EXPECT_EQ(
      reason("<flowRoot id='a' fill='url(#m)'/>"),
      "drawing.svg: flowRoot \"a\": it is flowed text; to change its mesh, convert it to text.");
  const std::string clone = "<use id='a' xlink:href='#q' fill='url(#m)'/>";
  const auto defs = [&](const std::string& shown) {
    return "<defs>" + shown + "</defs><g xmlns:xlink='http://www.w3.org/1999/xlink'>" + clone +
           "</g>";
  };
  for (const std::string shown :
       {"<rect id='q'/>", "<g id='q'><rect fill='red'/><text>x</text></g>",
        "<symbol id='q'><use xlink:href='#q'/><path/></symbol>"})
    EXPECT_TRUE(reason(defs(shown)).find("unlink the clone") != std::string::npos) << shown;
  EXPECT_EQ(listing(defs("<rect id='q' fill='red'/>")), "");
  const auto lent = [&](const std::string& inside, const std::string& outside) {
    return "<g id='g' fill='url(#m)'><g id='i'><rect id='q'/></g>" + inside + "</g>" +
           "<g xmlns:xlink='http://www.w3.org/1999/xlink'>" + outside + "</g>";
  };
  for (const std::string id : {"q", "i"})
    EXPECT_TRUE(reason(lent("", "<use xlink:href='#" + id + "'/>")).find("a clone outside") !=
                std::string::npos);
  EXPECT_EQ(listing(lent("", "<use xlink:href='#g'/>")), "q fill=m; ");
  EXPECT_EQ(listing(defs("<g id='q' fill='red'><rect/></g>")), "");
}

TEST(SvgObjects, clones_of_clones_take_neither_stack_nor_time) {
  std::string uses, shapes, clones;
  for (int i = 0; i < 30'000; ++i) {
    const std::string id = std::to_string(i), next = std::to_string(i + 1);
    uses += "<use id='u" + id + "' xlink:href='#u" + next + "'/>";
    shapes += "<rect id='r" + id + "'/>";
    clones += "<use xlink:href='#r" + id + "'/>";
  }
  const std::string lender = "<g fill='url(#m)' xmlns:xlink='http://www.w3.org/1999/xlink'>";
  SvgTree chained = parse_body(lender + "<use xlink:href='#u0'/><defs>" + uses + "</defs></g>");
  // Too far from the end.
  EXPECT_EQ(mesh_objects(chained).at(0).left_alone, LeftAlone::clone);
  SvgTree cloned = parse_body(
      lender + shapes + "</g><g xmlns:xlink='http://www.w3.org/1999/xlink'>" + clones + "</g>");
  const auto objects = mesh_objects(cloned);
  EXPECT_EQ(std::ranges::count(objects, LeftAlone::cloned, &MeshObject::left_alone), 30'000);
}

TEST(SvgObjects, simple_style_rules) {
  const auto with = [](const std::string& css) {
    return listing("<style>" + css + "</style><rect id='a' class='x y' fill='none'/>");
  };
  EXPECT_EQ(with("rect{fill:url(#m)}"), "a fill=m; ");
  EXPECT_EQ(with("path, .y ,#b{fill:url(#m);}"), "a fill=m; ");
  EXPECT_EQ(with("#a{fill:url(#m)} .y{fill:red} rect{fill:blue}"), "a fill=m; ");
  EXPECT_EQ(with(".y{fill:url(#n)} .x{fill:url(#m)}"), "a fill=m; ");
  EXPECT_EQ(with("<![CDATA[ /* } */ @import 'a;b'; @media print { rect{fill:red} } rect { stroke: "
                 "none; fill: url(\"#m\") } ]]>"),
            "a fill=m; ");
  EXPECT_EQ(with("svg rect{fill:url(#m)}"), "a fill=m; ");
  EXPECT_EQ(with("rect.x{fill:url(#m)} .y.x{fill:none}"), "");
  EXPECT_EQ(with("rect{fill:url(#m)"), "");
}

TEST(SvgObjects, definitions_are_not_listed) {
  for (const std::string element : {"defs", "clipPath", "mask", "symbol", "pattern", "marker"})
    EXPECT_EQ(listing("<" + element + "><g><rect id='a' fill='url(#m)'/></g></" + element + ">"),
              "");
  EXPECT_EQ(listing("<x:rect xmlns:x='urn:other' id='a' fill='url(#m)'/>"), "");
}

TEST(SvgObjects, missing_ids_are_written) {
  SvgTree document =
      parse_body("<rect id=\"rect1\"/><rect fill=\"url(#m)\"/><rect id=\"\" fill=\"url(#m)\"/>");
  const auto objects = mesh_objects(document);
  ASSERT_EQ(objects.size(), 2u);
  EXPECT_EQ(objects[0].id, "rect2");
  EXPECT_EQ(objects[1].id, "rect3");
  EXPECT_NE(document.serialize().find("<rect fill=\"url(#m)\" id=\"rect2\"/>"), std::string::npos);
  EXPECT_EQ(mesh_objects(document).at(1).id, "rect3");
  EXPECT_EQ(document.give_id(add_child(document.root(), "g"), "a\xc2\xa0(\xc3\xa4%"),
            "a__\xc3\xa4_4");
}

TEST(SvgObjects, transform_to_document) {
  SvgTree document = parse_body(
      "<g transform='translate(100 0) scale(2)'><g transform='rotate(90)'><path id='a' "
      "fill='url(#m)' transform='translate(1,2)'/></g></g>");
  const Affine map = to_document(mesh_objects(document).at(0));
  // (3, 4) -> (4, 6) -> (-6, 4) -> (88, 8)
  const glm::dvec2 p = map.point({3, 4});
  EXPECT_NEAR(p.x, 88, 1e-12);
  EXPECT_NEAR(p.y, 8, 1e-12);

  SvgTree bad = parse_body("\n<g transform='scale('><path id='a' fill='url(#m)'/></g>");
  const auto objects = mesh_objects(bad);
  EXPECT_EQ(complaint([&] { to_document(objects.at(0)); }),
            "drawing.svg: group in line 2: its transform \"scale(\" is malformed.");
}

TEST(SvgTree, unreadable_documents_give_the_reason) {
  const std::string start = "drawing.svg is not a readable SVG document: ";
  EXPECT_EQ(parse_complaint(""), start + "it is empty.");
  EXPECT_EQ(parse_complaint("plain text"), start + "Start tag expected, '<' not found (line 1).");
  EXPECT_EQ(parse_complaint(head + "\n<g>\n<path"),
            start + "Couldn't find end of Start Tag path line 3 (line 3).");
  EXPECT_EQ(parse_complaint(head + "\n<g>\n</svg>"),
            start + "Opening and ending tag mismatch: g line 2 and svg (line 3).");
  EXPECT_EQ(parse_complaint("<html/>"), start + "its outermost element is not <svg>.");
}

TEST(SvgTree, depth_is_limited) {
  std::string deep = head, end = "</svg>";
  for (int i = 0; i < 100000; ++i) {
    deep += "<g>";
    end.insert(0, "</g>");
  }
  EXPECT_TRUE(parse_complaint(deep + end)
                  .starts_with("drawing.svg is not a readable SVG document: 100001 elements lie "
                               "inside one another, more than the limit of 256"));

  // Text is no element, and neither the first child nor the last need be the deepest.
  std::string just = head, just_end = "</svg>";
  for (int i = 1; i < 256; ++i) {
    just += " <g>text<a/>";
    just_end.insert(0, "</g> ");
  }
  EXPECT_TRUE(parse_complaint(just + "text" + just_end).starts_with("drawing.svg"));
  const std::size_t last = just.rfind("<a/>");
  EXPECT_TRUE(parse(just.substr(0, last) + just_end).root());
}

TEST(SvgTree, keeps_what_it_does_not_know) {
  const std::string text =
      "<?xml version=\"1.0\" encoding=\"ISO-8859-1\" standalone=\"no\"?>\n"
      "<!DOCTYPE svg [\n<!ENTITY note \"plain\">\n]>\n"
      "<!-- before -->\n<?render fast?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:x=\"urn:other\" x:a=\"1\">\n"
      "  <!-- inside --><x:thing/><style><![CDATA[a > b {}]]></style>\n"
      "  <text title=\"&note; &lt;\">caf\xe9 &note; &amp;</text>\n"
      "</svg>\n<!-- after -->\n";
  EXPECT_EQ(parse(text).serialize(), text);
  EXPECT_EQ(parse(head + "\xc3\xa9</svg>").serialize(),
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + head + "\xc3\xa9</svg>\n");
}

TEST(SvgTree, can_be_read_again_whatever_its_encoding) {
#ifdef _WIN32
  GTEST_SKIP() << "libxml2 is built without iconv there.";
#endif
  for (const std::string encoding : {"UTF-7", "windows-1252", "KOI8-R", "ISO-8859-15", "ASCII"}) {
    const std::string text =
        "<?xml version=\"1.0\" encoding=\"" + encoding + "\"?>\n" + head + "<g id=\"a\"/></svg>\n";
    const std::string written = parse(text).serialize();
    EXPECT_TRUE(parse(written).find("a")) << encoding;
    EXPECT_EQ(written == text, encoding != "UTF-7");
  }
}

TEST(SvgTree, entities_are_taken_only_where_harmless) {
  const auto first_color = [](const std::string& entities, const std::string& paint) {
    SvgTree document = parse("<!DOCTYPE svg [" + entities + "]>" + head + gradients +
                             "<rect id='a' style=\"" + paint + "\"/></svg>");
    return mesh_objects(document).size();
  };
  EXPECT_EQ(first_color("<!ENTITY st \"fill:url(#m)\">", "&st;"), 1u);
  // As Illustrator declares namespaces.
  const std::string spaces =
      "<!DOCTYPE svg [<!ENTITY ns_svg \"http://www.w3.org/2000/svg\"><!ENTITY y \"urn:y\">]>\n"
      "<svg xmlns=\"&ns_svg;\" xmlns:y=\"&y;z\">";
  const SvgTree by_entity = parse(spaces + gradients + "<rect fill='url(#m)' y:a='1'/></svg>");
  EXPECT_EQ(mesh_objects(const_cast<SvgTree&>(by_entity)).size(), 1u);
  EXPECT_EQ(attribute(child_elements(by_entity.root(), "rect").at(0), "a", "urn:yz"), "1");
  EXPECT_NE(by_entity.serialize().find("xmlns:y=\"urn:yz\""), std::string::npos);
  EXPECT_EQ(complaint([&] {
              parse("<!DOCTYPE svg [<!ENTITY b \"x\"><!ENTITY a \"&b;\">]><svg xmlns='&a;'/>");
            }),
            "drawing.svg: svg in line 1: the entity \"a\" is not a short plain text.");
  EXPECT_EQ(
      complaint([&] { first_color("<!ENTITY a \"fill\"><!ENTITY b \"&a;:url(#m)\">", "&b;"); }),
      "drawing.svg: rectangle \"a\": the entity \"b\" is not a short plain text.");
}

TEST(SvgTree, entity_bomb_is_not_expanded) {
  std::string entities = "<!ENTITY e0 \"0123456789\">";
  for (int i = 1; i < 12; ++i) {
    std::string ten;
    for (int k = 0; k < 10; ++k) ten += "&e" + std::to_string(i - 1) + ";";
    entities += "<!ENTITY e" + std::to_string(i) + " \"" + ten + "\">";
  }
  const std::string start = "<!DOCTYPE svg [" + entities + "]>" + head + gradients;
  // Whether libxml2 refuses it or we do, it ends in a sentence and not in 10^12 characters.
  for (const std::string body : {"<rect id='a' style='&e11;'/>",
                                 "<rect id='&e11;' fill='url(#m)'/>", "<style>&e11;</style>"})
    EXPECT_TRUE(complaint([&] {
                  SvgTree document = parse(start + body + "</svg>");
                  mesh_objects(document);
                }).starts_with("drawing.svg"))
        << body;
}

TEST(SvgTree, external_entities_are_not_loaded) {
  const std::string secret = testing::TempDir() + "gradmesh_secret_" + std::to_string(::getpid());
  write_bytes(secret, "fill:url(#m)");
  const std::string uri = "file://" + secret;
  const std::string in_text = "<!DOCTYPE svg [<!ENTITY x SYSTEM \"" + uri + "\">]>" + head +
                              gradients + "<text id=\"a\">&x;</text></svg>";
  SvgTree document = parse(in_text);
  EXPECT_TRUE(mesh_objects(document).empty());
  EXPECT_EQ(document.serialize().find("fill:url"), std::string::npos);
  EXPECT_NE(document.serialize().find("<text id=\"a\">&x;</text>"), std::string::npos);
  // The same as an external DTD, and in a style sheet.
  EXPECT_EQ(parse("<!DOCTYPE svg SYSTEM \"" + uri + "\">" + head + "</svg>").find("a"), nullptr);
  EXPECT_EQ(parse_complaint("<!DOCTYPE svg [<!ENTITY x SYSTEM \"" + uri + "\">]>" + head +
                            "<style id=\"s\">&x;</style></svg>"),
            "drawing.svg: style \"s\": the entity \"x\" is not a short plain text.");
  std::filesystem::remove(secret);
}

}  // namespace
}  // namespace gradmesh
