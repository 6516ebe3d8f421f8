// Pictures of fewer pixels, and what programs show of them (raster/enlarge.h).
#include <gtest/gtest.h>

#include <cmath>

#include "base/parallel.h"
#include "raster/enlarge.h"

namespace gradmesh {
namespace {

/// A picture whose channels are these functions of the places of pixels, rounded down.
template <int Channels, class Level>
Raster<std::uint8_t, Channels> picture(int width, int height, const Level& level) {
  Raster<std::uint8_t, Channels> result(width, height);
  for (int c = 0; c < Channels; ++c)
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        *result.at(x, y, c) = std::uint8_t(level(c, (x + 0.5) / width, (y + 0.5) / height));
  return result;
}

double wavy(int channel, double x, double y) {
  return 128 + 60 * std::sin(3 * x + channel) + 60 * std::cos(4 * y - channel);
}

template <int Channels>
int largest_difference(const Raster<std::uint8_t, Channels>& a,
                       const Raster<std::uint8_t, Channels>& b) {
  int largest = 0;
  for (std::size_t i = 0; i < a.samples.size(); ++i)
    largest = std::max(largest, std::abs(a.samples[i] - b.samples[i]));
  return largest;
}

TEST(Enlarge, colours_change_evenly_between_the_middles_of_pixels) {
  Image two(2, 2);
  for (int y = 0; y < 2; ++y) two.set_pixel(1, y, {80, 40, 255});
  const Image shown = enlarged(two, 8, 2, two.window());
  const std::vector<int> red{0, 0, 10, 30, 50, 70, 80, 80}, blue{0, 0, 31, 95, 159, 223, 255, 255};
  for (int x = 0; x < 8; ++x) {
    EXPECT_EQ(*shown.at(x, 1, 0), red[std::size_t(x)]) << x;
    EXPECT_EQ(*shown.at(x, 1, 2), blue[std::size_t(x)]) << x;
  }
}

TEST(Enlarge, rows_are_those_of_the_whole) {
  const auto small = picture<3>(13, 9, wavy);
  const Image whole = enlarged(small, 50, 40, {0, 0, 50, 40});
  const Image rows = enlarged(small, 50, 40, {0, 17, 50, 31});
  for (int y = 17; y < 31; ++y)
    for (int x = 0; x < 50; ++x) ASSERT_EQ(rows.pixel(x, y), whole.pixel(x, y));
}

TEST(Enlarge, a_picture_stays_as_it_is_in_its_own_size) {
  const auto exact = picture<4>(20, 30, wavy);
  EXPECT_EQ(enlarged(exact, 20, 30, exact.window()), exact);
}

TEST(Reduce, one_colour_stays_that_colour) {
  for (const int level : {0, 1, 127, 254, 255}) {
    const Image exact(61, 47, std::uint8_t(level));
    EXPECT_EQ(reduced(exact, 17, 5), Image(17, 5, std::uint8_t(level)));
  }
}

TEST(Reduce, an_enlarged_picture_has_the_levels_of_the_exact_one) {
  const auto exact = picture<3>(200, 160, wavy);
  for (const auto& [width, height] : {std::pair(100, 80), std::pair(67, 160), std::pair(40, 33)}) {
    const Image shown = enlarged(reduced(exact, width, height), 200, 160, exact.window());
    double sum = 0;
    // Beyond the middles of the outermost pixels colours go on as they are.
    for (int y = 8; y < 152; ++y)
      for (int x = 8; x < 192; ++x)
        for (int c = 0; c < 3; ++c) {
          const int difference = *shown.at(x, y, c) - *exact.at(x, y, c);
          ASSERT_LE(std::abs(difference), 1) << width << ": " << x << ", " << y;
          sum += difference;
        }
    // Rounding twice leaves it no darker.
    EXPECT_NEAR(sum / (144 * 184 * 3), 0, 0.05) << width;
  }
}

TEST(Reduce, colours_are_near_once_they_are_multiplied_by_opacities) {
  const auto exact = picture<4>(200, 160, wavy);
  const RgbaImage shown = enlarged(multiplied(reduced(exact, 67, 54)), 200, 160, exact.window());
  EXPECT_LE(largest_difference(shown, multiplied(exact)), 2);
}

TEST(Reduce, threads_make_no_difference) {
  const auto exact = picture<4>(200, 160, wavy);
  const ThreadLimit one(1);
  const RgbaImage alone = reduced(exact, 67, 54);
  const ThreadLimit many(4);
  EXPECT_EQ(reduced(exact, 67, 54), alone);
}

}  // namespace
}  // namespace gradmesh
