#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.h"
#include "branch_meshes.h"
#include "mesh/rectangle.h"
#include "mesh/subdivide.h"
#include "mesh/validate.h"
#include "meshes.h"
#include "ops/split/split.h"
#include "raster/rasterizer.h"
#include "simplify/simplify.h"

namespace gradmesh {
namespace {

using test::grid_mesh;
using test::patches;

RunOptions line_options(double epsilon, MetricKind metric = MetricKind::flip) {
  RunOptions options;
  options.method = "lines";
  options.metric = metric;
  options.epsilon = epsilon;
  options.resolution = 150;
  return options;
}

Mesh noisy_grid(int rows, int columns, unsigned seed, ColorModel model = ColorModel::bilinear) {
  return grid_mesh({.rows = rows,
                    .columns = columns,
                    .position_noise = 0.05,
                    .color_noise = 0.04,
                    .color_model = model},
                   seed);
}

TEST(Grid, is_found_row_by_row_from_the_corner_where_the_patches_begin) {
  const Mesh mesh = grid_mesh({.rows = 3, .columns = 4});
  const std::optional<Rectangle> grid = find_grid(mesh);
  ASSERT_TRUE(grid);
  EXPECT_EQ(grid->rows, 3);
  EXPECT_EQ(grid->columns, 4);
  ASSERT_EQ(grid->tops.size(), 12u);
  for (int i = 0; i < 12; ++i) EXPECT_EQ(grid->tops[i], Halfedge{4 * i});
  EXPECT_EQ(grid->top(2, 1), Halfedge{4 * 9});
}

TEST(Grid, is_only_a_rectangle_without_T_junctions) {
  EXPECT_TRUE(find_grid(grid_mesh({.rows = 1, .columns = 1})));
  EXPECT_TRUE(find_grid(grid_mesh({.rows = 1, .columns = 5})));
  for (const MeshParts& parts : {test::l_branch(), test::u_branch(), test::cross(3), test::ring(7),
                                 test::dumbbell(), test::two_components()})
    EXPECT_FALSE(find_grid(build_mesh(parts)));

  Mesh mesh = grid_mesh({.rows = 2, .columns = 2});
  Journal journal(mesh);
  split(journal, mesh.sides(Face{0})[0], 0.4);
  EXPECT_FALSE(find_grid(mesh));
}

TEST(Grid, is_not_a_rectangle_that_is_joined_to_itself) {
  MeshParts parts = test::grid_parts({.rows = 2, .columns = 3});
  // The right side of the first row on the left one.
  parts.curves.push_back({{{4 * 2 + 1}, {}}, {{3}, {}}});
  EXPECT_FALSE(find_grid(build_mesh(parts)));
}

TEST(Lines, leave_a_grid_and_say_its_error_truly) {
  for (const MetricKind metric : {MetricKind::flip, MetricKind::ssim})
    for (const double epsilon : {0.005, 0.02, 0.06}) {
      const Mesh original = noisy_grid(5, 7, 3);
      Mesh mesh = original;
      const SimplifyResult result = simplify(mesh, line_options(epsilon, metric));
      EXPECT_EQ(validate(mesh), std::vector<std::string>{});
      const std::optional<Rectangle> grid = find_grid(mesh);
      ASSERT_TRUE(grid);
      EXPECT_EQ(grid->rows * grid->columns, result.patches_after);
      EXPECT_LE(result.error, epsilon);
      EXPECT_NEAR(result.error, result.error_added_up, 1e-6);
      const auto rasterizer = make_software_rasterizer();
      const Image before = rasterizer->paint(original, result.frame);
      const Image after = rasterizer->paint(mesh, result.frame);
      EXPECT_NEAR(result.error, mean(make_metric(metric, before)->map(after)), 1e-12);
      if (epsilon > 0.05) {
        EXPECT_LT(result.patches_after, 35);
      }
    }
}

/// The same mesh with the patches turned: each counts its sides from another corner.
MeshParts turned(const MeshParts& parts, unsigned seed) {
  std::mt19937 random(seed);
  MeshParts result = parts;
  std::vector<int> turns;
  for (Patch& patch : result.patches) {
    const int turn = turns.emplace_back(int(random() % 4));
    std::array<Cubic<Value>, 4> sides;
    std::array<Value, 4> twists;
    for (int k = 0; k < 4; ++k) {
      sides[k] = patch.side((k + turn) % 4);
      twists[k] = patch.twist((k + turn) % 4);
    }
    patch = patch_from_sides(sides, twists);
  }
  for (CurveParts& curve : result.curves)
    for (CurveSide* side : {&curve.a, &curve.b})
      for (int& h : side->halfedges) h = h - h % 4 + (h % 4 - turns[h / 4] + 4) % 4;
  return result;
}

TEST(Lines, are_the_same_however_the_patches_are_turned) {
  for (const unsigned seed : {1u, 2u, 3u, 4u}) {
    const MeshParts parts = test::grid_parts(
        {.rows = 4, .columns = 6, .position_noise = 0.04, .color_noise = 0.04}, seed);
    Mesh straight = build_mesh(parts), mesh = build_mesh(turned(parts, seed));
    simplify(straight, line_options(0.06));
    simplify(mesh, line_options(0.06));
    EXPECT_EQ(validate(mesh), std::vector<std::string>{});
    EXPECT_TRUE(find_grid(mesh));
    EXPECT_LT(mesh.face_count(), 24);
    EXPECT_EQ(mesh.face_count(), straight.face_count());
  }
}

TEST(Lines, that_were_added_exactly_go_again_and_no_others) {
  const Mesh coarse = grid_mesh({.rows = 3,
                                 .columns = 2,
                                 .position_noise = 0.1,
                                 .color_noise = 0.3,
                                 .color_model = ColorModel::bicubic},
                                7);
  Mesh mesh = build_mesh(subdivided(coarse, 3));
  ASSERT_EQ(mesh.face_count(), 54);
  // FLIP charges 0.03 for a pixel that is rounded to the next level: this allows one in ten.
  simplify(mesh, line_options(3e-3));
  ASSERT_EQ(mesh.face_count(), 6);
  const std::vector<Patch> left = patches(mesh), before = patches(coarse);
  for (int i = 0; i < 6; ++i) EXPECT_LE(test::difference(left[i], before[i]), 1e-6);
}

TEST(Lines, go_down_to_one_patch_where_all_may_go) {
  Mesh mesh = noisy_grid(4, 6, 5);
  EXPECT_EQ(simplify(mesh, line_options(1)).patches_after, 1);
  EXPECT_EQ(validate(mesh), std::vector<std::string>{});
}

TEST(Lines, of_small_cost_go_first) {
  // In one direction colours are those of an exact refinement, in the other they are not.
  const Mesh coarse = grid_mesh(
      {.rows = 4, .columns = 1, .color_noise = 0.4, .color_model = ColorModel::bicubic}, 2);
  Mesh mesh = build_mesh(subdivided(coarse, 2));
  ASSERT_EQ(mesh.face_count(), 16);
  simplify(mesh, line_options(3e-3));
  const std::optional<Rectangle> grid = find_grid(mesh);
  ASSERT_TRUE(grid);
  EXPECT_EQ(grid->rows, 4);
  EXPECT_EQ(grid->columns, 1);
}

TEST(Lines, do_not_depend_on_the_number_of_threads) {
  const Mesh original = noisy_grid(6, 6, 9, ColorModel::bicubic);
  std::optional<std::vector<Patch>> first;
  for (const int threads : {1, 2, 5}) {
    Mesh mesh = original;
    RunOptions options = line_options(0.02);
    options.threads = threads;
    simplify(mesh, options);
    EXPECT_LT(mesh.face_count(), 36);
    if (!first) first = patches(mesh);
    EXPECT_EQ(patches(mesh), *first) << threads << " threads";
  }
}

TEST(Lines, of_other_meshes_are_refused_and_these_stay_as_they_were) {
  for (const MeshParts& parts : {test::l_branch(), test::ring(7), test::two_components()}) {
    const Mesh original = build_mesh(parts);
    Mesh mesh = original;
    try {
      simplify(mesh, line_options(0.1));
      FAIL() << "taken for a grid";
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("one rectangle of patches"), std::string::npos);
    }
    EXPECT_EQ(patches(mesh), patches(original));
  }
}

TEST(Lines, stay_whole_when_the_run_is_cancelled) {
  for (const int after : {0, 3, 20}) {
    Mesh mesh = noisy_grid(5, 7, 3);
    RunOptions options = line_options(0.1);
    int asked = 0;
    options.progress = [&](const Progress& p) {
      EXPECT_LE(p.done, p.total);
      return ++asked <= after;
    };
    options.threads = 1;
    const SimplifyResult result = simplify(mesh, options);
    EXPECT_EQ(result.stopped, Stopped::cancelled);
    EXPECT_TRUE(find_grid(mesh));
    EXPECT_EQ(result.patches_after < 35, after == 20);
  }
}

/// As if coarse meshes could not be written.
class FineRules : public WritingRules {
 public:
  explicit FineRules(std::vector<int>& seen) : seen_(seen) {}

  WrittenForm form(const Mesh& mesh, const Frame&) const override {
    EXPECT_TRUE(find_grid(mesh));
    seen_.push_back(mesh.face_count());
    if (mesh.face_count() >= 12) return {mesh};
    return {build_mesh({{test::straight_patch({})}, {}, ColorModel::bilinear})};
  }

 private:
  /// The patches of the meshes that were asked about.
  std::vector<int>& seen_;
};

TEST(Lines, are_taken_back_whole_where_what_is_written_costs_more) {
  const Mesh original = noisy_grid(4, 4, 11);
  RunOptions options = line_options(0.3);
  std::vector<int> seen;
  options.rules = std::make_shared<FineRules>(seen);
  Mesh mesh = original;
  const SimplifyResult result = simplify(mesh, options);
  ASSERT_GT(seen.size(), 1u);
  EXPECT_LT(seen.front(), 12);
  EXPECT_GE(result.patches_after, 12);
  EXPECT_TRUE(find_grid(mesh));
  EXPECT_EQ(validate(mesh), std::vector<std::string>{});
}

}  // namespace
}  // namespace gradmesh
