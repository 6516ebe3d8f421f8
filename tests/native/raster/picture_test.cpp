// Pictures of meshes alone (raster/picture.h).
#include <gtest/gtest.h>

#include <cmath>

#include "meshes.h"
#include "raster/picture.h"

namespace gradmesh {
namespace {

/// A square of 8 units, which changes from left to right and has its opacity from top to bottom.
Mesh square() {
  const auto corner = [](double x, double y, double red, double opacity) {
    return Value{{x, y}, {red, 0.5, 0.2, opacity}};
  };
  return build_mesh(parts_of({{1,
                               1,
                               {test::straight_patch({corner(0, 0, 0, 1), corner(8, 0, 1, 1),
                                                      corner(8, 8, 1, 0), corner(0, 8, 0, 0)})}}}));
}

/// A frame of so many pixels a unit, in which the origin is at `origin`.
Frame frame(int size, double scale, glm::dvec2 origin) {
  return {size, size, Affine::translation(origin) * Affine::scaling(glm::dvec2(scale))};
}

TEST(Picture, has_colors_that_are_not_multiplied_and_opacities) {
  const MeshImage picture = picture_of(square(), frame(160, 20, {}));
  for (int y = 0; y < 160; ++y)
    for (int x = 0; x < 160; ++x) {
      ASSERT_TRUE(*picture.covered.at(x, y));
      const auto [red, green, blue, opacity] = picture.samples.pixel(x, y);
      // Inkscape takes some point of the pixel, and rounds down.
      EXPECT_NEAR(red, 255 * (x + 0.5) / 160, 2);
      EXPECT_NEAR(green, 127.5, 1);
      EXPECT_NEAR(blue, 51, 1);
      EXPECT_NEAR(opacity, 255 - 255 * (y + 0.5) / 160, 2);
    }
}

TEST(Picture, shows_the_nearest_color_around_the_mesh) {
  const MeshImage picture = picture_of(square(), frame(40, 2, {12, 12}));
  EXPECT_FALSE(*picture.covered.at(11, 20));
  EXPECT_TRUE(*picture.covered.at(12, 20));
  for (int y = 12; y < 28; ++y)
    for (int x = 0; x < 12; ++x) {
      EXPECT_EQ(picture.samples.pixel(x, y), picture.samples.pixel(12, y));
      EXPECT_EQ(picture.samples.pixel(39 - x, y), picture.samples.pixel(27, y));
    }
  EXPECT_EQ(picture.samples.pixel(0, 0), picture.samples.pixel(12, 12));
  EXPECT_EQ(picture.samples.pixel(39, 39), picture.samples.pixel(27, 27));
}

TEST(Picture, of_nothing_is_empty) {
  const MeshImage picture = picture_of(square(), frame(4, 1, {50, 50}));
  for (const std::uint8_t covered : picture.covered.samples) EXPECT_EQ(covered, 0);
}

}  // namespace
}  // namespace gradmesh
