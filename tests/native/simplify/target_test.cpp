// A number or share of handles or of patches instead of an error (simplify/target.h).
#include <gtest/gtest.h>

#include "form/handles.h"
#include "mesh/validate.h"
#include "meshes.h"
#include "simplify/simplify.h"
#include "simplify/target.h"

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

TEST(Target, at_most_as_many_handles_as_asked_for) {
  const int before = count_handles(rough_mesh());
  for (const char* method : {plain_method, best_method, line_method})
    for (const double share : {0.6, 0.2}) {
      Mesh by_ratio = rough_mesh(), by_number = rough_mesh();
      RunOptions options = small_options();
      options.method = method;
      options.count = Count::handles;
      options.ratio = share;
      const SimplifyResult result = simplify(by_ratio, options);
      EXPECT_EQ(validate(by_ratio), std::vector<std::string>{});
      EXPECT_EQ(result.handles_after, count_handles(by_ratio));
      EXPECT_LE(result.handles_after, share * before) << method;
      EXPECT_GT(result.error, 0);

      options.count.reset();
      options.ratio.reset();
      options.handles = int(share * before);
      EXPECT_EQ(simplify(by_number, options).error, result.error);
      EXPECT_EQ(count_handles(by_number), result.handles_after);
    }
}

TEST(Target, patches_can_be_counted_where_handles_are_taken_out) {
  Mesh mesh = rough_mesh();
  RunOptions options = small_options();
  options.method = plain_method;
  options.patches = 16;
  EXPECT_LE(simplify(mesh, options).patches_after, 16);
}

TEST(Target, what_is_counted_follows_the_target_then_the_method_then_the_document) {
  const auto counted = [](auto set) {
    SimplifyOptions options;
    set(options);
    const Count by_default = what_is_counted(options, Count::handles);
    EXPECT_EQ(what_is_counted(options, Count::patches),
              options.method == simplest && !options.has_target() ? Count::patches : by_default);
    return by_default;
  };
  EXPECT_EQ(counted([](auto&) {}), Count::handles);
  EXPECT_EQ(counted([](auto& o) { o.patches = 3; }), Count::patches);
  EXPECT_EQ(counted([](auto& o) { o.method = "plain", o.patches = 3; }), Count::patches);
  EXPECT_EQ(counted([](auto& o) { o.method = "best", o.handles = 3; }), Count::handles);
  for (const Method& method : all_methods())
    EXPECT_EQ(counted([&](auto& o) { o.method = method.name; }), method.count);
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
  refuses([](RunOptions& o) { o.handles = 0; });
  refuses([](RunOptions& o) { o.ratio = 0; });
  refuses([](RunOptions& o) { o.ratio = 1.5; });
  refuses([](RunOptions& o) { o.patches = 3, o.ratio = 0.5; });
  refuses([](RunOptions& o) { o.handles = 30, o.ratio = 0.5; });
  refuses([](RunOptions& o) { o.handles = 30, o.patches = 3; });
  refuses([](RunOptions& o) { o.handles = 30, o.count = Count::patches; });
  refuses([](RunOptions& o) { o.patches = 3, o.count = Count::handles; });
  refuses([](RunOptions& o) { o.patches = 3, o.method = "manual", o.edges = {1}; });
}

}  // namespace
}  // namespace gradmesh
