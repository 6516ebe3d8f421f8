#include <gtest/gtest.h>

#include "meshes.h"
#include "problems.h"
#include "raster/rasterizer.h"

namespace gradmesh {
namespace {

/// The middle of the meshes here, and more than they are high.
constexpr double middle = 400, height = 1000;

/// What lies from x = `left` to x = `right`.
WeightedArea strip(double left, double right, double factor) {
  return {{{{{{left, -height}, {right, -height}, {right, height}, {left, height}}}}}, factor};
}

TEST(Weights, of_a_pixel_are_those_of_the_last_area_that_it_meets) {
  const Frame frame{8, 2};
  const auto weights = weights_in(frame, {strip(1, 6, 4), strip(3.5, 5, 0.25)});
  ASSERT_TRUE(weights);
  for (int y = 0; y < 2; ++y)
    EXPECT_EQ(std::vector<float>(weights->at(0, y), weights->at(0, y) + 8),
              (std::vector<float>{1, 4, 4, 0.25, 0.25, 4, 1, 1}));
  EXPECT_EQ(*weights_in(frame, {strip(3.5, 5, 0.25), strip(1, 6, 4)}),
            *weights_in(frame, {strip(1, 6, 4)}));
}

TEST(Weights, are_none_where_every_error_counts_once) {
  const Frame frame{8, 2};
  EXPECT_FALSE(weights_in(frame, {}));
  EXPECT_FALSE(weights_in(frame, {strip(2, 4, 1)}));
  EXPECT_FALSE(weights_in(frame, {strip(20, 30, 4)})) << "it is beyond the frame";
  EXPECT_FALSE(weights_in(frame, {strip(2, 4, 4), strip(1, 5, 1)}));
}

RunOptions with(std::vector<WeightedArea> areas) {
  RunOptions options;
  options.resolution = 120;
  options.weighted = std::move(areas);
  return options;
}

Mesh noisy() {
  return test::grid_mesh({.rows = 8, .columns = 8, .position_noise = 0.03, .color_noise = 0.04}, 3);
}

TEST(Weights, make_prices_of_their_own) {
  const Mesh mesh = noisy();
  const auto key = [&](std::vector<WeightedArea> areas) {
    return test::problem(mesh, with(std::move(areas))).price_key();
  };
  EXPECT_EQ(key({strip(0, middle, 4)}), key({strip(0, middle, 4)}));
  EXPECT_EQ(key({strip(0, middle, 1)}), key({}));
  EXPECT_NE(key({strip(0, middle, 4)}), key({}));
  EXPECT_NE(key({strip(0, middle, 4)}), key({strip(0, middle, 2)}));
  EXPECT_NE(key({strip(0, middle, 4)}), key({strip(middle, 2 * middle, 4)}));
}

TEST(Weights, are_known_to_no_device) {
  for (const bool has_weights : {false, true}) {
    const Problem problem = test::problem(noisy(), with({strip(0, middle, has_weights ? 4 : 1)}));
    int asked = 0;
    problem.price_with({nullptr, [&] { return ++asked, std::shared_ptr<Device>(); }, {}});
    problem.pricing_trial();
    EXPECT_EQ(asked, has_weights ? 0 : 1);
  }
}

/// What a run leaves, and the mean errors without weights in the left and the right half.
struct Left {
  int patches;
  double error, left, right;
};

Left run(const Mesh& original, const std::string& method, const RunOptions& weighted) {
  RunOptions options = weighted;
  options.method = method;
  options.epsilon = 0.02;
  Mesh mesh = original;
  const SimplifyResult result = simplify(mesh, options);
  const Reference plain(original, fit_frame(original, {}, options.resolution), options.metric);
  const Plane map = plain.metric().map(paint_whole(mesh, plain.frame()).image);
  const int centre = map.width / 2;
  const auto mean_in = [&](Window part) {
    return sum(map, part) / (double(part.width()) * part.height());
  };
  return {result.patches_after, result.error, mean_in({0, 0, centre, map.height}),
          mean_in({centre, 0, map.width, map.height})};
}

TEST(Weights, move_the_error_to_where_it_counts_less) {
  const Mesh mesh = noisy();
  for (const char* method : {"gqe", "best"}) {
    SCOPED_TRACE(method);
    const Left plain = run(mesh, method, with({}));
    const Left kept = run(mesh, method, with({strip(-middle, middle, 4)}));
    EXPECT_LT(kept.left, plain.left);
    EXPECT_LE(kept.error, 0.02);
    EXPECT_NEAR(kept.error, (4 * kept.left + kept.right) / 2, 0.02 * 0.1);

    const Left given_up = run(mesh, method, with({strip(middle, 3 * middle, 0.25)}));
    EXPECT_GT(given_up.right, plain.right);
    EXPECT_LT(given_up.patches, plain.patches);
    EXPECT_LE(given_up.error, 0.02);
  }
}

TEST(Weights, of_one_change_nothing) {
  const Mesh mesh = noisy();
  RunOptions plain = with({}), once = with({strip(0, middle, 1)});
  Mesh first = mesh, second = mesh;
  EXPECT_EQ(simplify(first, plain).error, simplify(second, once).error);
  EXPECT_EQ(test::patches(first), test::patches(second));
}

}  // namespace
}  // namespace gradmesh
