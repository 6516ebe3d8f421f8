// By how much edges of a picture have moved (metric/edge_shift.h).
#include "metric/edge_shift.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace gradmesh {
namespace {

constexpr int size = 96;

/// A soft edge, `width` pixels wide, across the middle, turned by `angle` and moved by `shift`.
Image edge_image(double angle, double shift, double width = 6, double contrast = 0.6) {
  Image image(size, size);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const double across = (x - size / 2) * std::cos(angle) + (y - size / 2) * std::sin(angle);
      const double t = std::clamp((across - shift) / width + 0.5, 0.0, 1.0);
      const auto level = std::uint8_t(std::lround(255 * (0.2 + contrast * t)));
      image.set_pixel(x, y, {level, level, level});
    }
  return image;
}

const Raster<std::uint8_t, 1> everywhere(size, size, 1);

Plane shifts(const Image& reference, const Image& test) {
  Plane map(size, size);
  EdgeShift(reference, everywhere).update(test, map.window(), map);
  return map;
}

float largest(const Plane& map) { return *std::ranges::max_element(map.samples); }

TEST(EdgeShift, is_the_distance_across_the_edge) {
  for (const double angle : {0.0, 0.4, 1.0, 1.5707963, 2.5})
    for (const double shift : {0.0, 0.5, -0.5, 1.0, -1.5}) {
      const Plane map = shifts(edge_image(angle, 0), edge_image(angle, shift));
      EXPECT_NEAR(*map.at(size / 2, size / 2), std::abs(shift), 0.12 + 0.15 * std::abs(shift))
          << angle << ", " << shift;
    }
}

TEST(EdgeShift, is_none_where_nothing_is_steep) {
  const Image soft = edge_image(0.3, 0, 200), moved = edge_image(0.3, 3, 200);
  EXPECT_EQ(largest(shifts(soft, moved)), 0);
  const Image flat(size, size, 128);
  EXPECT_EQ(largest(shifts(flat, edge_image(0, 0))), 0);
}

TEST(EdgeShift, is_none_where_pixels_do_not_count) {
  Raster<std::uint8_t, 1> left(size, size, 1);
  fill(left, Window{size / 2, 0, size, size}, std::uint8_t(0));
  Plane map(size, size);
  const Image before = edge_image(1.5707963, 0), after = edge_image(1.5707963, 1);
  EdgeShift(before, left).update(after, map.window(), map);
  EXPECT_NEAR(*map.at(size / 4, size / 2), 1, 0.3);
  EXPECT_EQ(*map.at(3 * size / 4, size / 2), 0);
}

TEST(EdgeShift, an_update_of_what_changed_is_that_of_all) {
  std::mt19937 random(5);
  const Image reference = edge_image(0.7, 0);
  const EdgeShift measure(reference, everywhere);
  Image test = edge_image(0.7, 0.5);
  Plane map(size, size), whole(size, size);
  measure.update(test, map.window(), map);
  for (int i = 0; i < 20; ++i) {
    const int x = int(random() % (size - 20)), y = int(random() % (size - 20));
    const Window changed{x, y, x + 1 + int(random() % 20), y + 1 + int(random() % 20)};
    for (int c = 0; c < 3; ++c)
      for (int j = changed.y0; j < changed.y1; ++j)
        for (int k = changed.x0; k < changed.x1; ++k)
          *test.at(k, j, c) = std::uint8_t(random() % 256);
    measure.update(test, changed, map);
    measure.update(test, whole.window(), whole);
    ASSERT_EQ(map, whole) << i;
  }
}

}  // namespace
}  // namespace gradmesh
