#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "app/document/document.h"
#include "app/pages/read_document.h"
#include "branch_meshes.h"
#include "form/block_outline.h"
#include "formats/svg/group/new_svg.h"
#include "formats/svg/values/mesh_outline.h"
#include "mesh/boundary.h"
#include "mesh/subdivide.h"
#include "random_meshes.h"

namespace gradmesh {
namespace {

int boundary_leaves(const Mesh& mesh) {
  return int(std::ranges::count_if(mesh.halfedges(), [&](Halfedge h) {
    return mesh.is_leaf(h) && !mesh.other_side(h).valid();
  }));
}

/// Numbers of leaves in the loops; each must be closed, and all together must be the boundary.
std::multiset<int> loop_lengths(const Mesh& mesh) {
  std::multiset<int> lengths;
  std::set<Halfedge> seen;
  for (const std::vector<Halfedge>& loop : boundary_loops(mesh)) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      EXPECT_EQ(mesh.end(loop[i]), mesh.origin(loop[(i + 1) % loop.size()]));
      EXPECT_TRUE(seen.insert(loop[i]).second);
    }
    lengths.insert(int(loop.size()));
  }
  EXPECT_EQ(int(seen.size()), boundary_leaves(mesh));
  return lengths;
}

TEST(Boundary, is_found_as_closed_loops) {
  using Lengths = std::multiset<int>;
  EXPECT_EQ(loop_lengths(test::grid_mesh({.rows = 2, .columns = 5})), Lengths{14});
  EXPECT_EQ(loop_lengths(build_mesh(test::l_branch())), Lengths{8});
  EXPECT_EQ(loop_lengths(build_mesh(test::ring(7))), (Lengths{7, 7}));
  MeshParts both = test::ring(5);
  append(both, test::u_branch());
  EXPECT_EQ(loop_lengths(build_mesh(both)), (Lengths{5, 5, 10}));
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    const Mesh mesh = test::changed_mesh(
        test::grid_parts({.rows = 4, .columns = 4, .position_noise = 0.1}, random), seed, 12);
    EXPECT_EQ(loop_lengths(mesh).size(), 1u) << "seed " << seed;
  }
}

TEST(Boundary, faces_are_connected_across_curves) {
  MeshParts both = test::ring(5);
  append(both, test::u_branch());
  const Mesh mesh = build_mesh(both);
  EXPECT_EQ(face_components(mesh), (std::vector<int>{0, 0, 0, 0, 0, 1, 1, 1, 1}));
  Mesh divided = test::grid_mesh({.rows = 2, .columns = 2});
  Journal journal(divided);
  split(journal, divided.sides(Face{0})[0], 0.4);
  EXPECT_EQ(face_components(divided), std::vector<int>(5, 0));
}

TEST(Boundary, the_box_does_not_depend_on_how_finely_a_mesh_is_divided) {
  const Mesh mesh = test::grid_mesh({.rows = 2, .columns = 3, .position_noise = 0.3}, 4);
  const Affine view{glm::dmat2(0.8, 0.6, -0.6, 0.8), {5, 7}};
  const Box box = bounding_box(mesh, view),
            again = bounding_box(build_mesh(subdivided(mesh, 3)), view);
  for (int axis = 0; axis < 2; ++axis) {
    EXPECT_NEAR(box.low()[axis], again.low()[axis], 1e-9);
    EXPECT_NEAR(box.high()[axis], again.high()[axis], 1e-9);
  }
}

/// Twice the signed areas of the polygons through the points of the path's curves.
std::vector<double> areas(const std::string& path) {
  std::vector<double> result;
  std::vector<glm::dvec2> polygon;
  std::istringstream text(path);
  std::string word;
  while (text >> word) {
    if (word == "C") text >> word >> word >> word;
    if (word == "M") text >> word;
    if (word == "Z") {
      result.push_back(doubled_area(polygon));
      polygon.clear();
      continue;
    }
    const std::size_t comma = word.find(',');
    polygon.emplace_back(std::stod(word.substr(0, comma)), std::stod(word.substr(comma + 1)));
  }
  return result;
}

MeshParts one_square(bool mirrored) {
  MeshParts parts{{mirrored ? test::quad({1, 0}, {0, 0}, {0, 1}, {1, 1}) : test::square(0, 0)}, {}};
  return parts;
}

TEST(MeshOutline, holes_turn_against_their_outside) {
  const std::vector<double> found = areas(outline_path(build_mesh(test::ring(8))));
  ASSERT_EQ(found.size(), 2u);
  EXPECT_LT(found[0] * found[1], 0);
  EXPECT_GT(found[0] + found[1], 0);
}

TEST(MeshOutline, parts_that_lie_over_one_another_turn_the_same_way) {
  MeshParts parts = one_square(false);
  append(parts, one_square(true));
  for (const double area : areas(outline_path(build_mesh(parts)))) EXPECT_NEAR(area, 2, 1e-6);
  EXPECT_EQ(areas(outline_path(build_mesh(parts))).size(), 2u);
}

/// The new document of a bilinear mesh.
std::string written_svg(const Mesh& mesh, const std::optional<SvgStroke>& stroke = {}) {
  const BlockForm form = block_form(mesh, 1e-6);
  NewSvg made({{20, 20}});
  made.add(0, {"mesh", {outline_path(mesh)}, {}, {mesh, form, "label", counts_of(mesh)}, stroke});
  return made.tree().serialize();
}

/// It as it reads back.
std::unique_ptr<Document> written(const Mesh& mesh) {
  return parse_document(written_svg(mesh), "new.svg");
}

TEST(NewSvg, a_rectangle_is_one_gradient_and_a_ring_stays_closed) {
  const auto rectangle = written(test::grid_mesh({.rows = 2, .columns = 3}));
  ASSERT_EQ(rectangle->meshes().size(), 1u);
  EXPECT_FALSE(rectangle->meshes()[0].simplified);
  EXPECT_EQ(rectangle->mesh(rectangle->meshes()[0]).face_count(), 6);

  // One block holds a ring as well, but only blocks remember that its ends are joined.
  const Mesh ring = build_mesh(test::ring(8));
  EXPECT_EQ(block_form(ring, 0).blocks.size(), 1u);
  const auto closed = written(ring);
  EXPECT_TRUE(closed->meshes()[0].simplified);
  EXPECT_EQ(boundary_leaves(closed->mesh(closed->meshes()[0])), 16);
}

TEST(NewSvg, a_stroke_is_one_gradient_or_a_group_that_it_masks) {
  const SvgStroke stroke{.width = 3, .cap = "round", .dashes = {4, 2}};
  for (const Mesh& mesh : {test::grid_mesh({.rows = 2, .columns = 3}), build_mesh(test::ring(8))}) {
    const std::string svg = written_svg(mesh, stroke);
    const auto document = parse_document(svg, "new.svg");
    ASSERT_EQ(document->meshes().size(), 1u);
    EXPECT_EQ(document->meshes()[0].role, PaintRole::stroke);
    EXPECT_EQ(document->mesh(document->meshes()[0]).face_count(), mesh.face_count());
    const bool is_masked = svg.find("<mask") != svg.npos;
    EXPECT_EQ(is_masked, document->meshes()[0].simplified) << svg;
    for (const std::string part : {"stroke-width:3", "stroke-linecap:round", "stroke-dasharray:4"})
      EXPECT_NE(svg.find(part), svg.npos) << part << '\n' << svg;
  }
}

TEST(Blocks, are_found_however_the_faces_are_turned) {
  std::mt19937 random(3);
  MeshParts parts = test::grid_parts({.rows = 4, .columns = 5}, random);
  // Face f with its side f % 4 as the top: half-edges keep their places in the loop.
  for (std::size_t f = 0; f < parts.patches.size(); ++f) {
    const int turn = int(f % 4);
    std::array<Cubic<Value>, 4> sides;
    std::array<Value, 4> twists;
    for (int k = 0; k < 4; ++k) {
      sides[k] = parts.patches[f].side((k + turn) % 4);
      twists[k] = parts.patches[f].twist((k + turn) % 4);
    }
    parts.patches[f] = patch_from_sides(sides, twists);
  }
  for (CurveParts& curve : parts.curves)
    for (CurveSide* side : {&curve.a, &curve.b})
      for (int& h : side->halfedges) h = h / 4 * 4 + (h % 4 - h / 4 % 4 + 4) % 4;
  const std::vector<Rectangle> blocks = block_form(build_mesh(parts), 0).blocks;
  ASSERT_EQ(blocks.size(), 1u);
  EXPECT_EQ(blocks[0].tops.size(), 20u);
}

}  // namespace
}  // namespace gradmesh
