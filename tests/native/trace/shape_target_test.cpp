#include "trace/shape_target.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "trace/line_fit.h"
#include "trace/traced_grid.h"

namespace gradmesh {
namespace {

/// A turned ellipse as a polygon.
Outline ellipse(glm::dvec2 center, glm::dvec2 radii, double angle = 0) {
  std::vector<glm::dvec2> polygon;
  for (int k = 0; k < 360; ++k) {
    const double a = k * std::numbers::pi / 180;
    const glm::dvec2 p = radii * glm::dvec2(std::cos(a), std::sin(a));
    polygon.push_back(center + glm::dvec2(std::cos(angle) * p.x - std::sin(angle) * p.y,
                                          std::sin(angle) * p.x + std::cos(angle) * p.y));
  }
  return {polygon};
}

std::size_t counted(const FilledOutline& shape, int width, int height) {
  const std::vector<float> pixels = counted_pixels(shape, width, height);
  return std::size_t(std::ranges::count(pixels, 1.0f));
}

RgbaImage image_of(int width, int height, const auto& color) {
  RgbaImage image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) image.set_pixel(x, y, color(x, y));
  return image;
}

TEST(ShapeTarget, counts_what_lies_in_the_shape_completely) {
  EXPECT_EQ(counted({{{{2, 3}, {7, 3}, {7, 5}, {2, 5}}}}, 10, 10), 10);
  EXPECT_EQ(counted({{{{2.1, 3}, {7, 3}, {7, 5}, {2.1, 5}}}}, 10, 10), 8);
  const Outline rings{ellipse({50, 50}, {40, 40}).front(), ellipse({50, 50}, {20, 20}).front()};
  const double disc = std::numbers::pi * 40 * 40, hole = std::numbers::pi * 20 * 20;
  EXPECT_NEAR(double(counted({rings, FillRule::nonzero}, 100, 100)), disc, 0.06 * disc);
  EXPECT_NEAR(double(counted({rings, FillRule::evenodd}, 100, 100)), disc - hole,
              0.12 * (disc - hole));
  // Beyond the picture nothing counts, and a shape may reach there.
  EXPECT_EQ(counted({{{{-5, -5}, {50, -5}, {50, 50}, {-5, 50}}}}, 10, 10), 100);
}

TEST(ShapeTarget, counts_shares_of_what_is_thin) {
  const std::vector<float> pixels =
      counted_pixels({{{{1, 1.25}, {4, 1.25}, {4, 1.75}, {1, 1.75}}}}, 5, 3);
  EXPECT_FLOAT_EQ(pixels[5 + 1], 0.5f);
  EXPECT_FLOAT_EQ(std::accumulate(pixels.begin(), pixels.end(), 0.0f), 1.5f);
}

TEST(ShapeTarget, pixels_count_as_the_last_area_says_that_meets_them) {
  const auto rectangle = [](double left, double right) {
    return FilledOutline{{{{left, 0}, {right, 0}, {right, 2}, {left, 2}}}};
  };
  TargetPicture target;
  target.width = 6;
  target.height = 2;
  target.pixels.resize(12);
  weigh(target, {{{rectangle(0, 3.5)}, 4}, {{rectangle(3, 5), rectangle(9, 12)}, 0.5}});
  const std::vector<float> row{4, 4, 4, 0.5, 0.5, 1};
  for (int x = 0; x < 6; ++x) EXPECT_EQ(target.weight(x, 1), row[std::size_t(x)]) << x;
  target.weights[7] = 0;
  weigh(target, {{{rectangle(0, 6)}, 2}});
  EXPECT_EQ(target.weight(0, 1), 8);
  EXPECT_EQ(target.weight(1, 1), 0);
}

TEST(ShapeTarget, a_straight_frame_has_the_pixels_of_the_picture) {
  const FilledOutline shape{ellipse({30, 20}, {12, 9})};
  const ShapeFrame frame = straight_frame(shape.outline);
  EXPECT_EQ(frame.to_picture, Affine::translation({17, 10}));
  EXPECT_EQ(frame.size(), glm::dvec2(26, 20));
  const RgbaImage image = image_of(60, 40, [](int x, int y) {
    return std::array<std::uint8_t, 4>{std::uint8_t(4 * x), std::uint8_t(5 * y), 9, 255};
  });
  const TargetPicture target = target_of_shape(image, shape, frame, 1);
  for (const glm::ivec2 at : {glm::ivec2(0, 0), {13, 10}, {25, 19}})
    EXPECT_EQ(target.at(at.x, at.y), level_for(image.pixel(17 + at.x, 10 + at.y)));
  EXPECT_EQ(target.weight(0, 0), 0);
  EXPECT_EQ(target.weight(13, 10), 1);
  EXPECT_EQ(target.point, point_of_pixels(1));
}

TEST(ShapeTarget, a_turned_frame_lies_along_the_shape) {
  EXPECT_FALSE(turned_frame(ellipse({100, 100}, {60, 20})));
  EXPECT_FALSE(turned_frame(ellipse({100, 100}, {40, 38}, 0.6)));
  for (const double angle : {0.5, -0.6, 0.7}) {
    const FilledOutline shape{ellipse({100, 100}, {60, 15}, angle)};
    const auto frame = turned_frame(shape.outline);
    ASSERT_TRUE(frame) << angle;
    EXPECT_NEAR(frame->width * frame->height, 122 * 32, 400);
    // A picture that is linear is the same wherever and however it is looked at.
    const RgbaImage image = image_of(200, 200, [](int x, int y) {
      return std::array<std::uint8_t, 4>{std::uint8_t(x), std::uint8_t(y), 60, 255};
    });
    const TargetPicture target = target_of_shape(image, shape, *frame, 1);
    EXPECT_EQ(target.point, 0.5);
    const double beyond = point_of_pixels(1);
    for (int y = 0; y < target.height; y += 3)
      for (int x = 0; x < target.width; x += 5) {
        if (target.weight(x, y) == 0) continue;
        const glm::dvec2 place = frame->to_picture.point({x + 0.5, y + 0.5}) - beyond;
        EXPECT_NEAR(target.at(x, y).r, (place.x + 0.5) * 256 / 257, 1e-3);
        EXPECT_NEAR(target.at(x, y).g, (place.y + 0.5) * 256 / 257, 1e-3);
      }
  }
}

/// Inkscape paints a level that lies between two now as one and now as the other (raster/
/// cairo_like.cpp): as often as it should be, but for this.
TEST(ShapeTarget, levels_are_those_that_cairo_paints_in_the_mean) {
  for (const int level : {0, 1, 100, 200, 254, 255}) {
    const auto wanted = std::uint8_t(level);
    const double asked = double(level_for({wanted, wanted, wanted, 255}).r);
    EXPECT_EQ(std::lround(asked), level);
    double sum = 0;
    constexpr int steps = 1000;
    for (int k = 0; k < steps; ++k)
      sum += std::floor((asked + (k + 0.5) / steps - 0.5) * 257 / 256);
    EXPECT_NEAR(sum / steps, level, 2.0 / steps);
  }
}

TEST(ShapeTarget, what_lies_around_the_shape_changes_nothing) {
  const FilledOutline shape{ellipse({40, 30}, {25, 20})};
  const ShapeFrame frame = straight_frame(shape.outline);
  std::mt19937 random(5);
  std::uniform_int_distribution<int> level(0, 255);
  std::vector<LineGrid> grids;
  for (const bool is_noisy : {false, true}) {
    const RgbaImage image = image_of(80, 60, [&](int x, int y) -> std::array<std::uint8_t, 4> {
      const glm::dvec2 away = (glm::dvec2(x, y) + 0.5 - glm::dvec2(40, 30)) / glm::dvec2(28, 23);
      if (is_noisy && away.x * away.x + away.y * away.y > 1)
        return {std::uint8_t(level(random)), std::uint8_t(level(random)), 0, 255};
      return {std::uint8_t(3 * x), std::uint8_t(120 + 2 * y - x), 77, 255};
    });
    const TargetPicture target = target_of_shape(image, shape, frame, 1);
    std::vector<Beginning> beginnings;
    for (const LineGrid& grid : even_grids(target, frame.size(), 49))
      beginnings.push_back({&target, grid});
    StopWatch watch(0, {});
    const TracedGrid traced = traced_grid(beginnings, 49, watch);
    EXPECT_LT(std::sqrt(traced.squares / (3 * target.counted())), 1);
    EXPECT_NEAR(traced.squares, squares_of(traced.grid, target), 3 * target.counted());
    grids.push_back(traced.grid);
  }
  EXPECT_EQ(grids[0].points(), grids[1].points());
}

}  // namespace
}  // namespace gradmesh
