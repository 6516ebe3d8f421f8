// A number or share of patches instead of an error (simplify/target.h).
#include <gtest/gtest.h>

#include "mesh/validate.h"
#include "meshes.h"
#include "simplify/simplify.h"

namespace gradmesh {
namespace {

using test::grid_mesh;

Mesh rough_mesh() {
  return grid_mesh({.rows = 6, .columns = 6, .position_noise = 0.03, .color_noise = 0.03}, 5);
}

RunOptions small_options() {
  RunOptions options;
  options.resolution = 150;
  return options;
}

TEST(Target, as_many_patches_as_asked_for_with_an_error_not_worth_improving) {
  for (const int patches : {30, 20, 12, 5}) {
    Mesh mesh = rough_mesh();
    RunOptions options = small_options();
    options.patches = patches;
    const SimplifyResult result = simplify(mesh, options);
    EXPECT_EQ(validate(mesh), std::vector<std::string>{});
    EXPECT_EQ(result.patches_after, mesh.face_count());
    EXPECT_LE(result.patches_after, patches);
    EXPECT_EQ(result.stopped, Stopped::done);

    Mesh stricter = rough_mesh();
    options.patches.reset();
    options.epsilon = result.error / 1.2;
    EXPECT_GT(simplify(stricter, options).patches_after, patches);
  }
}

TEST(Target, a_share_counts_the_patches_before) {
  Mesh by_ratio = rough_mesh(), by_number = rough_mesh();
  RunOptions options = small_options();
  options.ratio = 0.5;
  const SimplifyResult result = simplify(by_ratio, options);
  options.ratio.reset();
  options.patches = 18;
  EXPECT_EQ(simplify(by_number, options).error, result.error);
  EXPECT_LE(result.patches_after, 18);
}

TEST(Target, a_mesh_that_has_no_more_patches_stays) {
  Mesh mesh = grid_mesh({.rows = 1, .columns = 1}, 1);
  RunOptions options = small_options();
  options.patches = 1;
  const SimplifyResult result = simplify(mesh, options);
  EXPECT_EQ(result.patches_after, 1);
  EXPECT_EQ(result.stopped, Stopped::nothing_to_merge);
}

TEST(Target, the_time_budget_and_a_cancel_keep_the_best_so_far) {
  Mesh mesh = rough_mesh();
  RunOptions options = small_options();
  options.patches = 4;
  options.time_budget = 1e-9;
  EXPECT_EQ(simplify(mesh, options).stopped, Stopped::budget);
  EXPECT_EQ(validate(mesh), std::vector<std::string>{});
  options.time_budget = 0;
  options.progress = [](const Progress&) { return false; };
  EXPECT_EQ(simplify(mesh, options).stopped, Stopped::cancelled);
}

TEST(Target, the_same_for_any_number_of_threads) {
  RunOptions options = small_options();
  options.ratio = 0.4;
  Mesh alone = rough_mesh(), together = rough_mesh();
  options.threads = 1;
  const SimplifyResult one = simplify(alone, options);
  options.threads = 4;
  const SimplifyResult four = simplify(together, options);
  EXPECT_EQ(one.error, four.error);
  EXPECT_EQ(one.patches_after, four.patches_after);
}

TEST(Target, refuses_what_makes_no_sense) {
  Mesh mesh = rough_mesh();
  const auto refuses = [&](auto set) {
    RunOptions options = small_options();
    set(options);
    EXPECT_THROW(simplify(mesh, options), std::invalid_argument);
  };
  refuses([](RunOptions& o) { o.patches = 0; });
  refuses([](RunOptions& o) { o.ratio = 0; });
  refuses([](RunOptions& o) { o.ratio = 1.5; });
  refuses([](RunOptions& o) { o.patches = 3, o.ratio = 0.5; });
  refuses([](RunOptions& o) { o.patches = 3, o.method = "manual", o.edges = {1}; });
}

}  // namespace
}  // namespace gradmesh
