#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "app/document/document.h"
#include "app/pages/read_document.h"
#include "corners.h"
#include "form/block_outline.h"
#include "form/rounding.h"
#include "form/written_patch.h"
#include "formats/svg/gradient/mesh_gradient.h"
#include "formats/svg/group/mesh_group.h"
#include "formats/svg/group/write_group.h"
#include "formats/svg/tree/own.h"
#include "formats/svg/values/reference.h"
#include "mesh/build.h"
#include "mesh/validate.h"
#include "random_meshes.h"
#include "same_mesh.h"
#include "svg_documents.h"

namespace gradmesh {
namespace {

using test::difference;
using test::grid_mesh;

using test::complaint;
using test::elements_called;

const std::string gradient =
    "<defs><meshgradient id='m' x='0' y='0' "
    "gradientUnits='userSpaceOnUse'><meshrow><meshpatch><stop path='l 100,0' "
    "stop-color='#f00'/><stop path='l 0,100' stop-color='#0f0'/><stop path='l -100,0' "
    "stop-color='#00f'/><stop path='l' "
    "stop-color='#fff'/></meshpatch></meshrow></meshgradient></defs>";
const std::string filled = "<rect id='p' width='400' height='400' fill='url(#m)'/>";

constexpr double tolerance = 0.001;

void write(SvgTree& document, const MeshObject& object, const Mesh& mesh) {
  write_group(document, object, {mesh, block_form(mesh, tolerance), "label", {24, 9}});
}

/// What a run measures of a mesh that is written so.
Mesh as_measured(const Mesh& mesh) {
  return build_mesh(block_parts(mesh, block_form(mesh, tolerance)));
}

/// The document with this content in which the mesh was written in the place of its first mesh, as
/// it is read again.
SvgTree after_writing(const std::string& body, const Mesh& mesh) {
  SvgTree document = test::svg_tree(gradient + body);
  write(document, mesh_objects(document).at(0), mesh);
  return SvgTree::parse(document.serialize(), "d.svg");
}

/// The element that an attribute such as clip-path names.
xmlNode* held_by(const SvgTree& document, const xmlNode* node, const char* name) {
  return referenced(document, attribute(node, name));
}

/// A mesh of random merges and splits, as a document may hold it: colours of 8 bits.
Mesh random_mesh(unsigned seed) {
  std::mt19937 random(seed);
  MeshParts parts = test::grid_parts(
      {.rows = 4, .columns = 4, .position_noise = 0.08, .color_noise = 0.3}, random);
  for (Patch& patch : parts.patches) patch = as_written(patch, 0);
  return test::changed_mesh(parts, seed, 20);
}

/// Which face of `b` each face of `a` is, by the patches.
std::map<Face, Face> match(const Mesh& a, const Mesh& b, double most) {
  std::map<Face, Face> found;
  std::set<Face> taken;
  for (const Face f : a.faces())
    for (const Face g : b.faces())
      if (difference(as_written(a.patch(f), tolerance), as_written(b.patch(g), tolerance)) < most &&
          taken.insert(g).second) {
        found[f] = g;
        break;
      }
  return found;
}

/// Every curve as text: the faces along both sides, with the breaks between.
std::multiset<std::string> curves(const Mesh& mesh, const std::map<Face, Face>* renamed = nullptr) {
  std::multiset<std::string> result;
  for (const Halfedge h : mesh.halfedges()) {
    if (mesh.is_bar(h)) continue;
    std::vector<std::string> sides;
    for (const Halfedge side : {h, mesh[h].twin}) {
      if (!side.valid()) continue;
      std::string text;
      for (const Halfedge leaf : mesh.leaves(side)) {
        Face f = mesh.face(leaf);
        const auto around = mesh.sides(f);
        const int k = int(std::ranges::find(around, leaf) - around.begin());
        if (renamed) f = renamed->at(f);
        char at[32];
        std::snprintf(at, sizeof at, "@%.9f ", mesh.span(leaf).first);
        text += std::to_string(f.value) + "." + std::to_string(k) + at;
      }
      sides.push_back(text);
    }
    std::ranges::sort(sides);
    std::string all;
    for (const std::string& s : sides) all += s + "| ";
    result.insert(all);
  }
  return result;
}

TEST(SvgWrite, read_back_it_is_the_same_mesh) {
  int junctions = 0, nested = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    const Mesh mesh = random_mesh(seed);
    const std::string text =
        after_writing("<path id='p' d='M0,0 H400 V400 Z' fill='url(#m)'/>", mesh).serialize();
    const std::unique_ptr<Document> document = parse_document(text, "drawing.svg");
    ASSERT_EQ(document->meshes().size(), 1u);
    const Mesh back = document->mesh(document->meshes()[0]);
    ASSERT_EQ(validate(back), std::vector<std::string>{}) << "seed " << seed;
    ASSERT_EQ(back.face_count(), mesh.face_count());
    const Mesh measured = as_measured(mesh);
    const std::map<Face, Face> same = match(measured, back, 1e-8);
    ASSERT_EQ(same.size(), std::size_t(mesh.face_count())) << "seed " << seed;
    EXPECT_EQ(curves(measured, &same), curves(back)) << "seed " << seed;
    EXPECT_EQ(test::junctions(back), test::junctions(mesh));
    for (const Halfedge h : mesh.halfedges()) {
      junctions += mesh.is_stem(h);
      nested += mesh.is_stem(h) && mesh.is_parent(h);
    }
  }
  EXPECT_GT(junctions, 200);
  EXPECT_GT(nested, 30);
}

TEST(SvgWrite, no_point_is_rounded_by_more_than_a_tenth_of_the_tolerance) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Mesh mesh = random_mesh(seed);
    const BlockForm form = block_form(mesh, tolerance);
    EXPECT_EQ(form.precision.step, 1e-4);
    for (const Rectangle& block : form.blocks)
      for (const Halfedge top : block.tops) {
        const BezierNet net = bezier_net(mesh.patch(top)),
                        written = bezier_net(written_patch(mesh.patch(top), form.precision));
        for (const int k : {0, 1, 2, 3, 7, 11, 15, 14, 13, 12, 8, 4}) {
          const glm::dvec2 p = written[std::size_t(k / 4)][std::size_t(k % 4)].position;
          EXPECT_LE(glm::distance(p, net[std::size_t(k / 4)][std::size_t(k % 4)].position),
                    0.1 * tolerance);
        }
      }
  }
}

TEST(SvgWrite, shared_points_are_the_very_same_text) {
  const Mesh mesh = random_mesh(4);
  SvgTree document = after_writing(filled, mesh);
  // All corners of all blocks, as they are written: as many different ones as there are points.
  std::set<std::string> corners;
  for (const xmlNode* stop : elements_called(document.root(), "stop")) {
    const std::string path = attribute(stop, "path").value();
    corners.insert(path.substr(path.find_last_of(" LC") + 1));
  }
  EXPECT_EQ(corners.size(), std::size_t(std::ranges::distance(mesh.points())));
}

TEST(SvgWrite, halves_of_a_step_are_rounded_alike_where_the_last_bits_differ) {
  for (const double step : {1e-4, 0.01, 1.0})
    for (int n = -5000; n < 5000; n += 7) {
      const double half = (n + 0.5) * step;
      const double low = round_to_step(half * (1 - 1e-14), step),
                   high = round_to_step(half * (1 + 1e-14), step);
      EXPECT_EQ(low, high);
      EXPECT_LE(std::abs(low - half), 0.5001 * step);
      EXPECT_EQ(round_to_step(low, step), low);
    }
}

TEST(SvgWrite, takes_the_place_of_the_object) {
  SvgTree document = after_writing(
      "<g id='outer'><circle id='below' r='5'/><path id='p' transform='rotate(30)' "
      "style='fill:url(#m);fill-opacity:0.5;opacity:0.7' d='M0,0 H400 V400 "
      "Z'><title>Pear</title></path><circle id='above' r='5'/></g>",
      grid_mesh({.rows = 2, .columns = 2}));
  const auto children = child_elements(document.find("outer"));
  ASSERT_EQ(children.size(), 3u);
  xmlNode* group = children[1];
  EXPECT_EQ(svg_name(group), "g");
  EXPECT_EQ(attribute(group, "id"), "p");
  EXPECT_EQ(attribute(group, "transform"), "rotate(30)");
  const Declarations style = parse_declarations(attribute(group, "style").value());
  // Of the object and of its fill together: blocks must not be see-through one by one.
  EXPECT_EQ(style.at("opacity"), "0.35");
  EXPECT_FALSE(style.contains("fill-opacity"));
  EXPECT_FALSE(style.contains("fill"));
  EXPECT_EQ(attribute(group, "label", inkscape_namespace), "label");
  ASSERT_EQ(child_elements(group, "title").size(), 1u);
  // Clipped by the shape, which keeps its geometry and nothing else.
  xmlNode* shape = child_elements(held_by(document, group, "clip-path")).at(0);
  EXPECT_EQ(attribute(shape, "d"), "M0,0 H400 V400 Z");
  EXPECT_FALSE(attribute(shape, "transform") || attribute(shape, "id"));
  // The gradient served nobody else.
  EXPECT_EQ(document.find("m"), nullptr);
}

TEST(SvgWrite, needs_no_namespace_that_the_object_declares) {
  SvgTree document = after_writing(
      "<rect xmlns='http://www.w3.org/2000/svg' xmlns:n='urn:notes' n:say='ripe' id='p' "
      "width='400' height='400' fill='url(#m)'/>",
      grid_mesh());
  xmlNode* group = document.find("p");
  EXPECT_EQ(svg_name(group), "g");
  EXPECT_EQ(attribute(group, "say", "urn:notes"), "ripe");
  EXPECT_EQ(mesh_objects(document).size(), 1u);
}

TEST(SvgWrite, gives_no_meaning_to_prefixes_that_the_document_does_not_declare) {
  SvgTree document = after_writing(
      "<g id='g' gradmesh:version='1'><rect id='p' width='400' height='400' fill='url(#m)'/></g>",
      grid_mesh());
  EXPECT_FALSE(is_mesh_group(document.find("g")));
  EXPECT_TRUE(is_mesh_group(document.find("p")));
}

TEST(SvgWrite, does_not_use_a_prefix_that_is_none) {
  SvgTree document = after_writing(
      "<g xmlns:a:b='urn:gradmesh'><rect id='p' width='400' height='400' fill='url(#m)'/></g>",
      grid_mesh());
  ASSERT_TRUE(is_mesh_group(document.find("p")));
  EXPECT_EQ(read_mesh_group(document, document.find("p")).patches.size(), 9u);
}

TEST(SvgWrite, names_its_own_by_ids_that_a_url_can_hold) {
  SvgTree document =
      after_writing("<rect id=\"a)b 'c\" width='400' height='400' fill='url(#m)'/>", grid_mesh());
  const auto objects = mesh_objects(document);
  ASSERT_EQ(objects.size(), 1u);
  EXPECT_EQ(objects[0].id, "a)b 'c");
  EXPECT_EQ(read_mesh_group(document, objects[0].node).patches.size(), 9u);
  EXPECT_EQ(attribute(objects[0].node, "clip-path").value_or("").substr(0, 16), "url(#a_b__c-shap");
}

TEST(SvgWrite, keeps_the_stroke_above_and_effects_around) {
  SvgTree document = after_writing(
      "<rect id='p' width='400' height='400' class='c' clip-path='url(#k)' "
      "style='fill:url(#m);stroke:#00f;stroke-width:4;filter:url(#f)'/><style>.c { opacity: 0.5 "
      "}</style>",
      grid_mesh());
  xmlNode* outer = document.find("p");
  EXPECT_EQ(attribute(outer, "clip-path"), "url(#k)");
  EXPECT_EQ(document.styles().declared(outer, "filter"), "url(#f)");
  EXPECT_EQ(document.styles().declared(outer, "opacity"), "0.5");
  const auto parts = child_elements(outer);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_TRUE(is_mesh_group(parts[0]));
  EXPECT_EQ(svg_name(parts[1]), "rect");
  EXPECT_EQ(document.styles().declared(parts[1], "fill"), "none");
  EXPECT_EQ(document.styles().declared(parts[1], "stroke"), "#00f");
  EXPECT_EQ(document.styles().declared(parts[1], "stroke-width"), "4");
  // The rule must not act twice.
  EXPECT_EQ(document.styles().declared(parts[1], "opacity"), "1");
  EXPECT_FALSE(document.styles().declared(parts[1], "filter"));
}

TEST(SvgWrite, masks_a_stroke_in_white) {
  SvgTree document = after_writing(
      "<g stroke-width='30'><path id='p' d='M50,50 L300,300' fill='none' stroke='url(#m)' "
      "stroke-linecap='round'/></g>",
      grid_mesh());
  xmlNode* group = document.find("p");
  xmlNode* shape = child_elements(held_by(document, group, "mask")).at(0);
  EXPECT_EQ(document.styles().declared(shape, "stroke"), "#ffffff");
  EXPECT_EQ(document.styles().declared(shape, "stroke-width"), "30");
  EXPECT_EQ(document.styles().declared(shape, "stroke-linecap"), "round");
  EXPECT_EQ(document.styles().declared(shape, "fill"), "none");
  EXPECT_EQ(mesh_objects(document).at(0).role, PaintRole::stroke);
}

TEST(SvgWrite, leaves_other_users_of_the_gradient_alone) {
  const std::string other = "<rect id='q' width='9' height='9' fill='url(#m)'/>";
  SvgTree document = after_writing(filled + other, grid_mesh());
  ASSERT_NE(document.find("m"), nullptr);
  const auto objects = mesh_objects(document);
  ASSERT_EQ(objects.size(), 2u);
  EXPECT_EQ(objects[1].id, "q");
  EXPECT_EQ(read_mesh(document, objects[1]).patches.size(), 1u);
}

TEST(SvgWrite, opacities_are_a_mask_of_greys) {
  std::mt19937 random(3);
  MeshParts parts = test::grid_parts({.rows = 3, .columns = 3, .color_noise = 0.2}, random);
  test::change_corners(parts, [](Value& v) { v.color.a = v.position.x < 150 ? 1 : 102 / 255.0; });
  for (Patch& patch : parts.patches) patch = as_written(patch, 0);
  Mesh mesh = build_mesh(parts);
  Journal journal(mesh);
  merge(journal, test::between(mesh, Face{3}, Face{4}));
  for (const char* paint : {"fill", "stroke"}) {
    const std::string body = "<rect id='p' width='400' height='400' style=\"fill:none;" +
                             std::string(paint) + ":url(#m)\"/>";
    SvgTree document = after_writing(body, mesh);
    for (int round = 0; round < 2; ++round) {
      const auto objects = mesh_objects(document);
      ASSERT_EQ(objects.size(), 1u);
      EXPECT_EQ(objects[0].id, "p");
      // Where two blocks paint one pixel, an opaque one leaves no trace.
      for (const xmlNode* stop : elements_called(document.root(), "stop"))
        EXPECT_EQ(attribute(stop, "stop-opacity"), std::nullopt);
      const Mesh back = build_mesh(read_mesh_group(document, objects[0].node));
      EXPECT_EQ(match(as_measured(mesh), back, 1e-8).size(), std::size_t(mesh.face_count()));
      write(document, objects[0], mesh);
    }
    // Opaque now: the mask goes.
    write(document, mesh_objects(document)[0], grid_mesh());
    EXPECT_EQ(opacity_mask(document, mesh_objects(document)[0].node), nullptr);
    EXPECT_EQ(elements_called(document.root(), "meshgradient").size(), 1u);
    EXPECT_EQ(elements_called(document.root(), "mask").size(), *paint == 's' ? 1u : 0u);
  }
}

TEST(SvgWrite, keeps_the_fallback_colour) {
  SvgTree document = after_writing(
      "<rect id='p' width='400' height='400' style='fill:url(#m) #abc'/>", random_mesh(1));
  for (int round = 0; round < 2; ++round) {
    const auto blocks = child_elements(document.find("p"));
    EXPECT_FALSE(blocks.empty());
    for (const xmlNode* block : blocks)
      EXPECT_EQ(fallback_color(document.styles().declared(block, "fill").value()), "#abc");
    write(document, mesh_objects(document).at(0), random_mesh(2));
  }
}

TEST(SvgWrite, renews_a_group_and_leaves_nothing_behind) {
  SvgTree document = after_writing(filled, random_mesh(1));
  const Mesh other = grid_mesh({.rows = 1, .columns = 2});
  write(document, mesh_objects(document).at(0), other);
  EXPECT_EQ(elements_called(document.root(), "meshgradient").size(), 1u);
  EXPECT_EQ(child_elements(document.find("p")).size(), 1u);
  const MeshCounts before = counts_before(mesh_objects(document).at(0));
  EXPECT_EQ(before.handles, 24);
  EXPECT_EQ(before.patches, 9);
  EXPECT_EQ(read_mesh_group(document, document.find("p")).patches.size(), 2u);
}

TEST(SvgWrite, both_paints_of_one_object) {
  const std::string body =
      "<rect id='p' width='100' height='100' stroke-width='9' "
      "style='fill:url(#m);stroke:url(#m)'/>";
  SvgTree document = test::svg_tree(gradient + body);
  const auto objects = mesh_objects(document);
  ASSERT_EQ(objects.size(), 2u);
  for (const MeshObject& o : objects) write(document, o, grid_mesh());
  const auto after = mesh_objects(document);
  ASSERT_EQ(after.size(), 2u);
  EXPECT_EQ(after[0].role, PaintRole::fill);
  EXPECT_EQ(after[1].role, PaintRole::stroke);
  EXPECT_EQ(read_mesh_group(document, after[0].node).patches.size(), 9u);
  EXPECT_EQ(read_mesh_group(document, after[1].node).patches.size(), 9u);
  EXPECT_EQ(document.find("m"), nullptr);
  // The stroke lies above the fill, and neither shape is left to paint by itself.
  const auto parts = child_elements(document.find("p"));
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_TRUE(attribute(parts[0], "clip-path"));
  EXPECT_TRUE(attribute(parts[1], "mask"));
  for (const xmlNode* part : parts) EXPECT_TRUE(child_elements(part, "rect").empty());
}

TEST(SvgGroup, whose_object_has_lost_its_id_gets_one_that_stays) {
  const std::string body =
      "<rect id='p' width='100' height='100' style='fill:url(#m);stroke:#00f'/>";
  SvgTree document = after_writing(body, grid_mesh());
  xmlNode* outer = document.find("p");
  ASSERT_FALSE(is_mesh_group(outer));
  xmlUnsetProp(outer, BAD_CAST "id");
  const std::string id = mesh_objects(document).at(0).id;
  EXPECT_EQ(document.find(id), outer);
  EXPECT_EQ(mesh_objects(document).at(0).id, id);
}

TEST(SvgGroup, says_what_is_missing) {
  const SvgTree good = after_writing(filled, random_mesh(1));
  const auto complaint_of = [&](const std::function<void(xmlNode*)>& spoil) {
    const SvgTree document = SvgTree::parse(good.serialize(), "d.svg");
    spoil(document.find("p"));
    return complaint([&] { build_mesh(read_mesh_group(document, document.find("p"))); });
  };
  EXPECT_EQ(complaint_of([](xmlNode* g) { remove_node(child_elements(g)[1]); }),
            "d.svg: group \"p\": one of its blocks is missing: undo what removed it.");
  EXPECT_EQ(complaint_of([](xmlNode* g) { set_own_attribute(child_elements(g)[1], "face", "0"); }),
            "d.svg: group \"p\": one of its blocks is there twice.");
  EXPECT_EQ(complaint_of([](xmlNode* g) { set_own_attribute(g, "curves", "1 | x"); }),
            "d.svg: group \"p\": its gradmesh:curves cannot be read.");
  EXPECT_NE(complaint_of([](xmlNode* g) { set_own_attribute(g, "curves", "1 | 1"); }),
            "nothing was thrown");
  EXPECT_NE(complaint_of([](xmlNode* g) {
              set_attribute(child_elements(g)[0], "transform", "scale(1e8)");
            }).find("it reaches beyond 5e8 user units."),
            std::string::npos);
}

TEST(Blocks, hold_every_face_once_and_whole_grids_in_one) {
  EXPECT_EQ(block_form(grid_mesh({.rows = 7, .columns = 5}), 0).blocks.size(), 1u);
  for (unsigned seed = 0; seed < 30; ++seed) {
    const Mesh mesh = random_mesh(seed);
    std::set<Face> faces;
    for (const Rectangle& block : block_form(mesh, 0).blocks) {
      EXPECT_EQ(block.tops.size(), std::size_t(block.rows * block.columns));
      for (const Halfedge top : block.tops) EXPECT_TRUE(faces.insert(mesh.face(top)).second);
      for (int i = 0; i < block.rows; ++i)
        for (int j = 0; j < block.columns; ++j) {
          if (j + 1 < block.columns) {
            EXPECT_EQ(mesh[mesh.sides(block.top(i, j))[1]].twin,
                      mesh.sides(block.top(i, j + 1))[3]);
          }
          if (i + 1 < block.rows) {
            EXPECT_EQ(mesh[mesh.sides(block.top(i, j))[2]].twin,
                      mesh.sides(block.top(i + 1, j))[0]);
          }
        }
    }
    EXPECT_EQ(faces.size(), std::size_t(mesh.face_count()));
  }
}

TEST(Blocks, are_cut_where_colors_step) {
  std::mt19937 random(1);
  MeshParts parts = test::grid_parts({.rows = 1, .columns = 2}, random);
  for (int i : {0, 3}) parts.patches[1].c[i][0].color = {1, 0, 1, 1};
  make_color_bilinear(parts.patches[1]);
  EXPECT_EQ(block_form(build_mesh(parts), 0).blocks.size(), 2u);
}

}  // namespace
}  // namespace gradmesh
