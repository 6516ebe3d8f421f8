#include <gtest/gtest.h>

#include "mesh/validate.h"
#include "meshes.h"
#include "ops/split/split.h"
#include "raster/rasterizer.h"
#include "simplify/simplify.h"

namespace gradmesh {
namespace {

using test::grid_mesh;

Mesh split_patch(int times) {
  Mesh mesh = grid_mesh({.rows = 1, .columns = 1, .position_noise = 0.2}, 8);
  Journal journal(mesh);
  for (int i = 0; i < times; ++i) split(journal, mesh.sides(Face{i})[0], 1.0 / (times + 1 - i));
  return mesh;
}

TEST(Simplify, takes_exact_splits_out_again) {
  Mesh mesh = split_patch(5);
  ASSERT_EQ(mesh.face_count(), 6);
  RunOptions options;
  options.resolution = 200;
  // The colours at the points between were rounded to 8 bits in the original; FLIP charges about
  // 0.03 where a pixel is one level off.
  options.epsilon = 0.02;
  const SimplifyResult result = simplify(mesh, options);
  EXPECT_EQ(result.patches_before, 6);
  EXPECT_EQ(result.patches_after, 1);
  EXPECT_EQ(mesh.face_count(), 1);
  EXPECT_LE(result.error, 0.02);
  EXPECT_EQ(result.stopped, Stopped::done);
}

TEST(Simplify, keeps_the_error_below_epsilon_and_says_it_truly) {
  for (const MetricKind metric : {MetricKind::flip, MetricKind::ssim})
    for (const double epsilon : {0.002, 0.01, 0.05}) {
      const Mesh original =
          grid_mesh({.rows = 6, .columns = 6, .position_noise = 0.03, .color_noise = 0.03}, 5);
      Mesh mesh = original;
      RunOptions options;
      options.metric = metric;
      options.epsilon = epsilon;
      options.resolution = 200;
      const SimplifyResult result = simplify(mesh, options);
      EXPECT_EQ(validate(mesh), std::vector<std::string>{});
      EXPECT_LE(result.error, epsilon);
      EXPECT_EQ(result.patches_after, mesh.face_count());
      const auto rasterizer = make_software_rasterizer();
      const Image before = rasterizer->paint(original, result.frame);
      const Image after = rasterizer->paint(mesh, result.frame);
      EXPECT_NEAR(result.error, mean(make_metric(metric, before)->map(after)), 1e-12);
      if (epsilon > 0.04) {
        EXPECT_LT(result.patches_after, 36);
      }
    }
}

TEST(Simplify, changes_nothing_where_nothing_can_be_merged) {
  Mesh mesh = grid_mesh({.rows = 1, .columns = 1});
  const SimplifyResult result = simplify(mesh, {});
  EXPECT_EQ(result.stopped, Stopped::nothing_to_merge);
  EXPECT_EQ(result.patches_after, 1);
  EXPECT_EQ(result.error, 0);

  Mesh noisy = grid_mesh({.rows = 4, .columns = 4, .color_noise = 0.8}, 2);
  RunOptions strict;
  strict.epsilon = 0;
  EXPECT_EQ(simplify(noisy, strict).stopped, Stopped::nothing_to_merge);
  EXPECT_EQ(noisy.face_count(), 16);
}

TEST(Simplify, is_the_same_for_any_number_of_threads_and_follows_the_seed) {
  const auto run = [](int threads, std::uint64_t seed) {
    Mesh mesh =
        grid_mesh({.rows = 6, .columns = 6, .position_noise = 0.05, .color_noise = 0.05}, 9);
    RunOptions options;
    options.method = "grid";
    options.threads = threads;
    options.seed = seed;
    options.resolution = 150;
    options.epsilon = 0.02;
    simplify(mesh, options);
    std::vector<Patch> patches;
    for (const Face f : mesh.faces()) patches.push_back(mesh.patch(f));
    return patches;
  };
  EXPECT_EQ(run(1, 3), run(2, 3));
  EXPECT_EQ(run(0, 3), run(1, 3));
  EXPECT_NE(run(1, 3), run(1, 4));
}

TEST(Simplify, stops_when_told_and_keeps_the_best_so_far) {
  int calls = 0;
  RunOptions options;
  options.method = "grid";
  options.resolution = 100;
  options.progress = [&](const Progress& p) {
    EXPECT_LE(p.done, p.total);
    return ++calls < 4;
  };
  Mesh mesh = split_patch(7);
  const SimplifyResult result = simplify(mesh, options);
  EXPECT_EQ(calls, 4);
  EXPECT_EQ(result.stopped, Stopped::cancelled);
  EXPECT_EQ(result.patches_after, 8 - 3);
  EXPECT_EQ(validate(mesh), std::vector<std::string>{});

  Mesh other = split_patch(7);
  RunOptions short_time;
  short_time.time_budget = 1e-9;
  EXPECT_EQ(simplify(other, short_time).stopped, Stopped::budget);
  EXPECT_EQ(other.face_count(), 8);
}

TEST(Simplify, refuses_options_out_of_range) {
  const auto refused = [](auto change) {
    Mesh mesh = grid_mesh();
    RunOptions options;
    change(options);
    EXPECT_THROW(simplify(mesh, options), std::invalid_argument);
  };
  refused([](RunOptions& o) { o.epsilon = -0.1; });
  refused([](RunOptions& o) { o.epsilon = std::nan(""); });
  refused([](RunOptions& o) { o.resolution = 3; });
  refused([](RunOptions& o) { o.time_budget = -1; });
  refused([](RunOptions& o) { o.threads = -1; });
  EXPECT_THROW(method_named("gqe2"), std::invalid_argument);
  EXPECT_THROW(metric_named("psnr"), std::invalid_argument);
}

}  // namespace
}  // namespace gradmesh
