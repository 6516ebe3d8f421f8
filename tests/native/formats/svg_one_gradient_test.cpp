#include <gtest/gtest.h>

#include "app/pages/read_document.h"
#include "app/runs/runs.h"
#include "form/written_patch.h"
#include "formats/svg/gradient/color_texts.h"
#include "formats/svg/gradient/mesh_gradient.h"
#include "formats/svg/gradient/written_gradient.h"
#include "formats/svg/tree/own.h"
#include "mesh/build.h"
#include "mesh/rectangle.h"
#include "meshes.h"
#include "svg_documents.h"

namespace gradmesh {
namespace {

using test::difference;
using test::elements_called;
using test::grid_mesh;

constexpr auto text = test::text_of_attribute;

/// A meshgradient of 2 x 2 squares of 10 units from (0, 0), with a tensor and an opacity.
std::string rows() {
  const std::string stop = "<stop path=\"l ", paint = "\" style=\"stop-color:#";
  const auto patch = [&](const std::string& stops) {
    return "<meshpatch>" + stops + "</meshpatch>";
  };
  return "<meshrow>" +
         patch(stop + "10,0" + paint + "ff0000;stop-opacity:0.37\"/>" + stop + "0,10" + paint +
               "808000\"/>" + stop + "-10,0" + paint + "408040\"/>" + stop + "0,-10" + paint +
               "800080\"/>") +
         patch(stop + "10,0\"/>" + stop + "0,10" + paint + "00ff00\"/>" + stop + "-10,0" + paint +
               "008080\"/>") +
         "</meshrow><meshrow>" +
         patch(stop + "0,10\"/>" + stop + "-10,0" + paint + "102030\"/>" + stop + "0,-10" + paint +
               "0000ff\"/>") +
         patch(stop + "0,10\"/>" + stop + "-10,0" + paint + "ffffff\"/>") + "</meshrow>";
}

std::string gradient(const std::string& id, const std::string& attributes,
                     const std::string& content = rows()) {
  return "<meshgradient id=\"" + id + "\" " + attributes + ">" + content + "</meshgradient>";
}

const std::string user_space = "gradientUnits='userSpaceOnUse'";

SvgTree parse(const std::string& defs, const std::string& body) {
  return test::svg_tree("<defs>" + defs + "</defs>" + body);
}

/// What control points may be off without anybody seeing it.
constexpr double tolerance = 1e-3;

Mesh read(const SvgTree& document, const MeshObject& object) {
  return build_mesh(read_mesh(document, object));
}

/// Takes all lines out of a mesh.
Mesh one_patch(const Mesh& mesh) {
  Mesh merged = mesh;
  RunOptions options;
  options.method = "lines";
  options.epsilon = 1;
  options.resolution = 50;
  simplify(merged, options);
  EXPECT_EQ(merged.face_count(), 1);
  return merged;
}

/// Replaces the mesh of the object `which` by one patch; the document, after what was read back was
/// found to be what was written.
SvgTree reduced(const std::string& defs, const std::string& body, int which = 0) {
  SvgTree document = parse(defs, body);
  const auto before = mesh_objects(document);
  const Mesh mesh = one_patch(read(document, before.at(which)));
  const MeshParts wanted = block_parts(
      mesh, gradient_form(mesh, tolerance, mesh_to_gradient(document, before.at(which))));
  write_mesh_gradient(document, before.at(which), mesh, tolerance);
  const auto after = mesh_objects(document);
  EXPECT_EQ(after.size(), before.size());
  for (std::size_t i = 0; i < after.size(); ++i) {
    EXPECT_EQ(after[i].node, before[i].node);
    EXPECT_EQ(after[i].role, before[i].role);
  }
  const Mesh again = read(document, after.at(which));
  EXPECT_EQ(again.is_smooth(), mesh.is_smooth());
  EXPECT_EQ(again.face_count(), 1);
  EXPECT_LE(difference(again.patch(Face{0}), wanted.patches[0]), 1e-9);
  return document;
}

TEST(OneGradient, keeps_the_object_and_what_else_it_says) {
  const std::string body =
      "<g id='g'><rect id='a'/><rect id='b' class='c' transform='scale(2)' width='20' height='20' "
      "style='stroke:#123456;fill:url(#m) #abcdef;opacity:0.5'/><rect id='z'/></g>";
  const SvgTree document = reduced(gradient("m", user_space), body);
  const xmlNode* object = document.find("b");
  EXPECT_EQ(text(object, "class"), "c");
  EXPECT_EQ(text(object, "transform"), "scale(2)");
  EXPECT_EQ(text(object, "style"), "fill:url(#b-mesh1) #abcdef;opacity:0.5;stroke:#123456");
  EXPECT_EQ(text(object->next, "id"), "z");
  EXPECT_EQ(text(object->prev, "id"), "a");
  EXPECT_EQ(document.find("m"), nullptr);
  EXPECT_EQ(parent_element(document.find("b-mesh1")), document.root()->children);
}

TEST(OneGradient, paints_the_parts_of_a_text_that_had_the_old_one) {
  const SvgTree document =
      reduced(gradient("m", user_space),
              "<text id='b'><tspan id='c' fill='url(#m)'>x</tspan><tspan "
              "id='d'><tspan id='e' style='fill:url(#m)'>y</tspan></tspan></text>");
  for (const char* id : {"b", "c", "e"})
    EXPECT_EQ(text(document.find(id), "style"), "fill:url(#b-mesh1)") << id;
  EXPECT_FALSE(attribute(document.find("c"), "fill") || attribute(document.find("d"), "style"));
  EXPECT_EQ(document.find("m"), nullptr);
}

TEST(OneGradient, takes_the_place_of_the_old_one_where_a_group_hands_it_on) {
  SvgTree document =
      reduced(gradient("m", user_space),
              "<g id='g' fill='url(#m)'><g><rect id='b'/></g><rect fill='red'/></g>");
  EXPECT_EQ(text(document.find("g"), "style"), "fill:url(#b-mesh1)");
  EXPECT_FALSE(attribute(document.find("g"), "fill"));
  EXPECT_EQ(document.find("m"), nullptr);
  for (const std::string other : {"<rect id='c'/>", "<use/>"}) {
    document = reduced(gradient("m", user_space),
                       "<g id='g' fill='url(#m)'><g><rect id='b'/></g>" + other + "</g>");
    EXPECT_EQ(text(document.find("g"), "fill"), "url(#m)") << other;
    EXPECT_NE(document.find("m"), nullptr);
  }
}

TEST(OneGradient, is_shared_by_those_that_shared_the_old_one) {
  const std::string painted = "<rect id='a' fill='url(#m)'/><rect id='b' fill='url(#m)'/>";
  const std::string copy = "<rect id='c' fill='url(#n)'/>";
  SvgTree document = parse(gradient("m", user_space) + gradient("n", user_space), painted + copy);
  GradientsByOrigin by_origin;
  for (const MeshObject& object : mesh_objects(document)) {
    const Mesh mesh = one_patch(read(document, object));
    write_mesh_gradient(document, object, mesh, tolerance, &by_origin);
  }
  EXPECT_EQ(text(document.find("a"), "style"), "fill:url(#a-mesh1)");
  EXPECT_EQ(text(document.find("b"), "style"), "fill:url(#a-mesh1)");
  // A copy was made to be changed by itself.
  EXPECT_EQ(text(document.find("c"), "style"), "fill:url(#c-mesh3)");
  EXPECT_EQ(elements_called(document.root(), "meshgradient").size(), 2u);
}

TEST(OneGradient, keeps_units_and_transform_and_short_numbers) {
  const SvgTree document = reduced(
      gradient("m",
               user_space + " x='5.5' y='0' gradientTransform='matrix(3,0.7,-0.3,0.1,17,0.05)'"),
      "<rect id='b' fill='url(#m)'/>");
  const xmlNode* mesh = document.find("b-mesh1");
  EXPECT_EQ(text(mesh, "gradientUnits"), "userSpaceOnUse");
  EXPECT_EQ(text(mesh, "gradientTransform"), "matrix(3,0.7,-0.3,0.1,17,0.05)");
  EXPECT_EQ(text(mesh, "x"), "5.5");
  EXPECT_EQ(text(mesh, "y"), "0");
  const auto stops = elements_called(mesh, "stop");
  ASSERT_EQ(stops.size(), 4u);
  EXPECT_TRUE(text(stops[0], "path").ends_with(" 20,0")) << text(stops[0], "path");
  EXPECT_TRUE(text(stops[1], "path").ends_with(" 0,20")) << text(stops[1], "path");
  EXPECT_EQ(text(stops[0], "stop-color"), "#f00");
  EXPECT_EQ(text(stops[0], "stop-opacity"), "0.37");
  EXPECT_EQ(text(stops[1], "stop-color"), "#0f0");
}

TEST(OneGradient, keeps_its_colours_from_the_rules_of_the_document) {
  const std::string rule = "<style>stop { stop-color: red; stop-opacity: 0.5 }</style>";
  const SvgTree document =
      reduced(rule + gradient("m", user_space), "<rect id='b' fill='url(#m)'/>");
  const auto stops = elements_called(document.find("b-mesh1"), "stop");
  EXPECT_EQ(text(stops[0], "style"), "stop-color:#f00;stop-opacity:0.37");
  EXPECT_EQ(text(stops[1], "style"), "stop-color:#0f0;stop-opacity:0.5");
}

/// Returns the rows with other texts for some of their colours.
std::string rows_of(const std::vector<std::pair<std::string, std::string>>& texts) {
  std::string changed = rows();
  for (const auto& [old, now] : texts) changed.replace(changed.find(old), old.size(), now);
  return changed;
}

TEST(OneGradient, writes_colours_as_they_stood) {
  const std::string content = rows_of({{"#ff0000", "rgba(255, 0, 0, 0.5)"},
                                       {"#808000", "lab(50 10 20)"},
                                       {"#00ff00", "hsl(120, 100, 45.9)"},
                                       {"#0000ff", "#00f icc-color(Ink, 1, 0.5)"}});
  SvgTree document = parse(gradient("m", user_space, content), "<rect id='b' fill='url(#m)'/>");
  const MeshObject object = mesh_objects(document).at(0);
  const Mesh mesh = one_patch(read(document, object));
  const MeshObject after = write_mesh_gradient(document, object, mesh, tolerance);
  const auto stops = elements_called(after.gradient, "stop");
  ASSERT_EQ(stops.size(), 4);
  EXPECT_EQ(text(stops[0], "stop-color"), "rgba(255, 0, 0, 0.5)");
  EXPECT_EQ(text(stops[0], "stop-opacity"), "0.37");
  EXPECT_EQ(text(stops[1], "stop-color"), "hsl(120, 100, 45.9)");
  EXPECT_EQ(text(stops[2], "stop-color"), "#fff");
  EXPECT_EQ(text(stops[3], "stop-color"), "#00f icc-color(Ink, 1, 0.5)");
}

TEST(OneGradient, writes_the_colours_of_what_it_remembers_as_they_stood) {
  const std::string content =
      rows_of({{"#808000", "lab(50 10 20)"}, {"#00ff00", "oklch(0.7 0.15 40)"}});
  SvgTree document = parse(gradient("m", user_space, content), "<rect id='b' fill='url(#m)'/>");
  const MeshObject object = mesh_objects(document).at(0);
  const Mesh whole = read(document, object);
  const ColorTexts texts = color_texts(document, object);
  const MeshObject once = write_mesh_gradient(document, object, one_patch(whole), tolerance);
  EXPECT_EQ(own_attribute(once.node, "fill-colors"), std::nullopt);
  remember_color_texts(once, texts);
  EXPECT_EQ(own_attribute(once.node, "fill-colors"), "lab(50 10 20);oklch(0.7 0.15 40)");
  const auto colors = [&](const MeshObject& written) {
    std::vector<std::string> found;
    for (const xmlNode* stop : elements_called(written.gradient, "stop"))
      found.push_back(text(stop, "stop-color"));
    return found;
  };
  EXPECT_EQ(std::ranges::count(colors(once), "lab(50 10 20)"), 0);
  const MeshObject twice = write_mesh_gradient(document, once, whole, tolerance);
  EXPECT_EQ(std::ranges::count(colors(twice), "lab(50 10 20)"), 1);
  EXPECT_EQ(std::ranges::count(colors(twice), "oklch(0.7 0.15 40)"), 1);
  remember_color_texts(twice, texts);
  forget_original(twice);
  EXPECT_EQ(own_attribute(twice.node, "fill-colors"), std::nullopt);
}

TEST(ColorTexts, finds_what_8_bits_cannot_tell_apart) {
  ColorTexts texts;
  EXPECT_TRUE(texts.is_empty());
  texts.add_list("hsl(0, 0, 50);color(srgb .503 .5 .5);rgb(255 0 0 / 0.5);red;;hsl(0, 0, 50)");
  EXPECT_EQ(texts.list(), "hsl(0, 0, 50);color(srgb .503 .5 .5);rgb(255 0 0 / 0.5)");
  const auto found = [&](const glm::dvec4& color) {
    const ColorText* const match = texts.find(color);
    return match ? match->text : "";
  };
  EXPECT_EQ(found({0.5, 0.5, 0.5, 1}), "hsl(0, 0, 50)");
  EXPECT_EQ(found({0.5, 0.5, 0.5, 0.2}), "hsl(0, 0, 50)");
  EXPECT_EQ(found({0.501, 0.499, 0.5, 1}), "hsl(0, 0, 50)");
  EXPECT_EQ(found({0.502, 0.5, 0.5, 1}), "color(srgb .503 .5 .5)");
  EXPECT_EQ(found({128 / 255.0, 127 / 255.0, 0.5, 1}), "hsl(0, 0, 50)");
  EXPECT_EQ(found({0.5, 0.503, 0.5, 1}), "");
  EXPECT_EQ(found({0.497, 0.5, 0.5, 1}), "");
  EXPECT_EQ(found({1, 0, 0, 0.25}), "rgb(255 0 0 / 0.5)");
  EXPECT_EQ(found({1, 0, 0, 0.6}), "");
  EXPECT_EQ(texts.find({1, 0, 0, 0.25})->opacity_beside(0.25), 0.5);
}

TEST(OneGradient, remembers_what_it_is_told_until_it_is_edited) {
  SvgTree document = parse(gradient("m", user_space), "<rect id='b' fill='url(#m)'/>");
  const MeshObject object = mesh_objects(document).at(0);
  const Mesh mesh = one_patch(read(document, object));
  const MeshObject after = write_mesh_gradient(document, object, mesh, tolerance);
  EXPECT_FALSE(is_as_written(document, after));
  remember_original(document, after, mesh, tolerance, "memory");
  xmlNode* written = after.gradient;
  EXPECT_EQ(own_attribute(after.node, "fill-original"), "memory");
  EXPECT_TRUE(is_as_written(document, after));

  xmlNode* stop = elements_called(written, "stop")[1];
  set_attribute(written, "gradientTransform", "rotate(30)");
  set_attribute(stop, "style", "stop-color:#00ff00;stop-opacity:1");
  EXPECT_TRUE(is_as_written(document, after)) << "moved, and written by another program";
  set_attribute(written, "x", "1e-9");
  EXPECT_TRUE(is_as_written(document, after)) << "rounded";
  set_attribute(stop, "style", "stop-color:#02ff00");
  EXPECT_FALSE(is_as_written(document, after)) << "another colour";
  set_attribute(stop, "style", "stop-color:#00ff00");
  set_attribute(written, "type", "bicubic");
  EXPECT_FALSE(is_as_written(document, after)) << "smooth colours";
  set_attribute(written, "type", "coons");
  EXPECT_TRUE(is_as_written(document, after));
  set_attribute(written, "x", "0.1");
  EXPECT_FALSE(is_as_written(document, after)) << "another place";
  for (const char* damaged : {"", "0", "-3", "-3 0", "x", "-99 0123456789abcdef"}) {
    set_own_attribute(after.node, "fill-written", damaged);
    EXPECT_FALSE(is_as_written(document, after)) << damaged;
  }
  write_mesh_gradient(document, after, mesh, tolerance);
  EXPECT_EQ(own_attribute(after.node, "fill-original"), std::nullopt);
  EXPECT_EQ(own_attribute(after.node, "fill-written"), std::nullopt);
}

TEST(OneGradient, stays_in_the_units_of_a_bounding_box) {
  for (const std::string units : {"", "gradientUnits='objectBoundingBox' "}) {
    const SvgTree document =
        reduced(gradient("m", units + "gradientTransform='scale(0.05)'"),
                "<rect id='b' x='3' y='7' width='30' height='70' fill='url(#m)'/>");
    const xmlNode* mesh = document.find("b-mesh1");
    EXPECT_EQ(text(mesh, "gradientUnits"), "objectBoundingBox");
    EXPECT_EQ(text(mesh, "x"), "0");
  }
}

TEST(OneGradient, has_its_rows_itself_where_the_old_one_borrowed_them) {
  const std::string defs =
      gradient("rows", user_space) + gradient("m", "x='3' y='4' xlink:href='#rows'", "");
  {
    const SvgTree document = reduced(defs, "<rect id='b' stroke='url(#m)'/>");
    const xmlNode* mesh = document.find("b-mesh1");
    EXPECT_EQ(attribute(mesh, "href", xlink_namespace), std::nullopt);
    EXPECT_EQ(text(mesh, "gradientUnits"), "userSpaceOnUse");
    EXPECT_EQ(text(mesh, "x"), "3");
    EXPECT_EQ(document.find("rows"), nullptr);
    EXPECT_EQ(document.find("m"), nullptr);
  }
  const SvgTree document =
      reduced(defs, "<rect id='b' stroke='url(#m)'/><rect id='c' fill='url(#rows)'/>");
  EXPECT_NE(document.find("rows"), nullptr);
  EXPECT_EQ(document.find("m"), nullptr);
}

TEST(OneGradient, leaves_the_old_one_to_others) {
  const std::string shared = "<g id='g' fill='url(#m) #fff'><rect id='a'/><rect id='b'/></g>";
  SvgTree document = reduced(gradient("m", user_space), shared, 1);
  EXPECT_EQ(text(document.find("b"), "style"), "fill:url(#b-mesh1) #fff");
  EXPECT_EQ(text(document.find("a"), "style"), "(none)");
  EXPECT_EQ(text(document.find("g"), "fill"), "url(#m) #fff");
  EXPECT_EQ(read(document, mesh_objects(document).at(0)).face_count(), 4);
}

TEST(OneGradient, is_for_one_of_two_paints) {
  const std::string body = "<rect id='b' fill='url(#m)' stroke='url(#m)'/>";
  SvgTree document = reduced(gradient("m", user_space), body, 1);
  EXPECT_EQ(text(document.find("b"), "fill"), "url(#m)");
  EXPECT_EQ(text(document.find("b"), "style"), "stroke:url(#b-mesh1)");
  EXPECT_NE(document.find("m"), nullptr);
}

TEST(OneGradient, of_a_smooth_mesh_stays_smooth_and_in_its_own_coordinates) {
  const std::string attributes =
      user_space + " type='bicubic' gradientTransform='matrix(1,0,0.4,2,9,1)'";
  const SvgTree document = reduced(gradient("m", attributes), "<rect id='b' fill='url(#m)'/>");
  const xmlNode* mesh = document.find("b-mesh1");
  EXPECT_EQ(text(mesh, "type"), "bicubic");
  EXPECT_EQ(text(mesh, "gradientTransform"), "matrix(1,0,0.4,2,9,1)");
  SvgTree again = SvgTree::parse(document.serialize(), "again.svg");
  const MeshObject object = mesh_objects(again).at(0);
  EXPECT_EQ(read(again, object).position(Point{0}), glm::dvec2(0, 0));
  EXPECT_EQ(mesh_to_user(again, object).point({10, 10}), glm::dvec2(23, 21));
  EXPECT_EQ(mesh_to_gradient(again, object), Affine());
}

/// Two patches far out: what is simplified of them has a handle beyond what a document may hold.
TEST(OneGradient, and_blocks_that_no_reader_would_take_are_not_written) {
  const std::string stop = "<stop stop-color='red' path=\"";
  const std::string far = "<meshrow><meshpatch>" + stop + "c 0,-4.9e8 0.9e8,0 1e8,0\"/>" + stop +
                          "l 0,1e8\"/>" + stop + "l -1e8,0\"/>" + stop +
                          "l 0,-1e8\"/></meshpatch><meshpatch>" + stop + "l 1e8,0\"/>" + stop +
                          "l 0,1e8\"/>" + stop + "l -1e8,0\"/></meshpatch></meshrow>";
  const auto document =
      parse_document("<svg xmlns='http://www.w3.org/2000/svg'>" + gradient("m", user_space, far) +
                         "<rect id='r' width='2e8' height='1e8' fill='url(#m)'/></svg>",
                     "far.svg");
  const std::string before = document->bytes();
  for (const std::string method : {"gqe", "lines"}) {
    RunOptions options;
    options.method = method;
    options.epsilon = 1;
    options.resolution = 50;
    EXPECT_EQ(
        test::complaint([&] { simplify(*document, {}, options); }),
        "far.svg: rectangle \"r\": its mesh would reach beyond 5e8 user units when it is written.");
    EXPECT_EQ(document->bytes(), before);
  }
}

TEST(OneGradient, parts_are_those_of_the_grid_in_its_order) {
  const Mesh mesh = grid_mesh({.rows = 2, .columns = 3, .position_noise = 0.1});
  const MeshParts parts = block_parts(mesh, gradient_form(mesh, tolerance, {}));
  ASSERT_EQ(parts.patches.size(), 6u);
  // The ninefold of a rounding by the tolerance, in twists.
  for (int i = 0; i < 6; ++i)
    EXPECT_LE(difference(parts.patches[i], as_written(mesh.patch(Face{i}), tolerance)),
              9 * 9 * tolerance);
  EXPECT_TRUE(find_grid(build_mesh(parts)));
}

}  // namespace
}  // namespace gradmesh
