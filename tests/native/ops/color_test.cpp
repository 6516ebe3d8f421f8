// Sharp colours at points (ops/color.h).
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "mesh/subdivide.h"
#include "mesh/validate.h"
#include "ops/color.h"
#include "ops/fix.h"
#include "random_meshes.h"

namespace gradmesh {
namespace {

using test::grid_mesh;
using test::patches;
using test::sound;

const glm::dvec4 red(1, 0, 0, 1);

/// The T-junction that a split of the middle one of nine patches makes on its upper neighbour's
/// side.
struct WithJunction {
  Mesh mesh = grid_mesh({.rows = 3, .columns = 3, .position_noise = 0.1, .color_noise = 0.2});
  Journal journal{mesh};
  Point junction = mesh.origin(split(journal, mesh.sides(Face{4})[0], 0.4));
};

int colors_at(const Mesh& mesh, Point point) {
  std::vector<glm::dvec4> colors;
  for (const Halfedge corner : corners_at(mesh, point)) {
    const auto is_same = [&](const glm::dvec4& c) {
      return glm::length(c - mesh[corner].color) < 1e-9;
    };
    if (std::ranges::none_of(colors, is_same)) colors.push_back(mesh[corner].color);
  }
  return int(colors.size());
}

TEST(Color, one_patch_alone_changes_at_a_sharp_corner) {
  Mesh mesh = grid_mesh();
  const std::vector<Patch> before = patches(mesh);
  Journal journal(mesh);
  const Halfedge corner = mesh.sides(Face{4})[1];
  recolor(journal, corner, red);
  EXPECT_EQ(validate(mesh), sound);
  EXPECT_EQ(corners_at(mesh, mesh.origin(corner)).size(), 4u);
  EXPECT_EQ(colors_at(mesh, mesh.origin(corner)), 2);
  EXPECT_EQ(mesh.patch(Face{4}).corner(1).color, red);
  for (const Face f : mesh.faces())
    EXPECT_EQ(mesh.patch(f) == before[std::size_t(f.value)], f != Face{4});
  EXPECT_EQ(journal.touched_since(0).size(), 3u);  // and those across both sides
}

TEST(Color, joined_colors_are_the_mean_of_all) {
  Mesh mesh = grid_mesh();
  Journal journal(mesh);
  const Halfedge corner = mesh.sides(Face{4})[1];
  const Point point = mesh.origin(corner);
  const glm::dvec4 smooth = mesh[corner].color;
  recolor(journal, corner, red);
  join_colors(journal, point);
  EXPECT_EQ(validate(mesh), sound);
  EXPECT_EQ(colors_at(mesh, point), 1);
  EXPECT_LT(glm::length(mesh[corner].color - (0.75 * smooth + 0.25 * red)), 1e-12);
}

TEST(Color, a_junction_follows_the_end_of_its_curve) {
  WithJunction made;
  const auto& [mesh, journal, junction] = made;
  const glm::dvec4 before = mesh[corners_at(mesh, junction).front()].color;
  // The first bar of the divided side starts at the corner of the patch that was split.
  recolor(made.journal, mesh.sides(Face{4})[0], red);
  EXPECT_EQ(validate(mesh), sound);
  for (const Halfedge corner : corners_at(mesh, junction))
    EXPECT_GT(glm::length(mesh[corner].color - before), 0.1);
}

TEST(Color, a_junction_has_colors_of_its_own_until_they_are_joined) {
  WithJunction made;
  const auto& [mesh, journal, junction] = made;
  const std::vector<Patch> before = patches(mesh);
  const std::vector<Halfedge> corners = corners_at(mesh, junction);
  ASSERT_EQ(corners.size(), 2u);
  recolor(made.journal, corners[0], red);
  EXPECT_EQ(validate(mesh), sound);
  EXPECT_TRUE(mesh[corners[0]].own_color && !mesh[corners[1]].own_color);
  join_colors(made.journal, junction);
  EXPECT_EQ(validate(mesh), sound);
  const std::vector<Patch> after = patches(mesh);
  for (std::size_t i = 0; i < before.size(); ++i)
    EXPECT_LT(test::difference(before[i], after[i]), 1e-12);
}

TEST(Color, a_patch_that_must_stay_keeps_the_colors_that_it_has) {
  WithJunction made;
  const Face other = made.mesh.face(made.mesh[made.mesh[made.junction].stem].twin);
  ASSERT_NE(other, Face{4});
  set_fixed(made.journal, {other}, true);
  // Its corner at the T-junction would follow.
  EXPECT_FALSE(can_recolor(made.mesh, made.mesh.sides(Face{4})[0]));
  EXPECT_FALSE(can_recolor(made.mesh, made.mesh.sides(other)[1]));
  EXPECT_TRUE(can_recolor(made.mesh, made.mesh.sides(Face{0})[0]));
}

TEST(Color, what_is_split_beside_a_sharp_corner_paints_the_same) {
  Mesh mesh = grid_mesh();
  Journal journal(mesh);
  recolor(journal, mesh.sides(Face{4})[1], red);
  const Patch whole = mesh.patch(Face{4});
  split(journal, mesh.sides(Face{4})[0], 0.3);
  EXPECT_LT(test::difference(mesh.patch(Face{4}), whole.part_v(0, 0.3)), 1e-12);
  EXPECT_LT(test::difference(mesh.patch(Face{9}), whole.part_v(0.3, 1)), 1e-12);
}

/// Recolours a corner, or joins the colours at its point.
void color_at_random(Journal& journal, std::mt19937& random, bool joins) {
  const Mesh& mesh = journal.mesh();
  const std::vector<Halfedge> leaves = test::all_leaves(mesh);
  const Halfedge corner = leaves[random() % leaves.size()];
  const auto channel = [&] { return double(random() % 256) / 255; };
  if (joins) {
    join_colors(journal, mesh.origin(corner));
  } else {
    const double r = channel(), g = channel();
    recolor(journal, corner, {r, g, channel(), 1});
  }
}

class ColorSequences : public testing::TestWithParam<ColorModel> {};

TEST_P(ColorSequences, of_merges_splits_colors_and_undo_keep_every_invariant) {
  int colored = 0, sharp = 0, undone = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    std::mt19937 random(seed);
    Mesh mesh = grid_mesh({.rows = 3,
                           .columns = 4,
                           .position_noise = 0.1,
                           .color_noise = 0.2,
                           .color_model = GetParam()},
                          seed);
    Journal journal(mesh);
    std::vector<Mesh> history{mesh};
    for (int step = 0; step < 30; ++step) {
      const unsigned action = random() % 8;
      if (action == 0 && history.size() > 1) {
        journal.undo();
        history.pop_back();
        ++undone;
        ASSERT_EQ(mesh, history.back()) << "seed " << seed << " step " << step;
        continue;
      }
      if (action < 5) {
        color_at_random(journal, random, action == 1);
        ++colored;
      } else {
        test::change_at_random(journal, random);
      }
      history.push_back(mesh);
      ASSERT_EQ(validate(mesh), sound) << "seed " << seed << " step " << step;
      ASSERT_EQ(validate(build_mesh(subdivided(mesh, 1))), sound) << "seed " << seed;
    }
    for (const Point p : mesh.points()) sharp += colors_at(mesh, p) > 1;
    journal.undo_to(0);
    ASSERT_EQ(mesh, history.front());
  }
  EXPECT_GT(colored, 700);
  EXPECT_GT(sharp, 200);
  EXPECT_GT(undone, 100);
}

INSTANTIATE_TEST_SUITE_P(Models, ColorSequences,
                         testing::Values(ColorModel::bilinear, ColorModel::bicubic));

}  // namespace
}  // namespace gradmesh
