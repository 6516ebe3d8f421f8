#include <gtest/gtest.h>

#include <glm/mat3x3.hpp>
#include <limits>

#include "base/error.h"
#include "formats/pdf/color/color_space.h"
#include "pdf_numbers.h"

namespace gradmesh {
namespace {

/// Expects a colour in levels of sRGB, 0 to 255, which have been rounded.
void expect_levels(const ColorSpace& space, const Numbers& components, glm::dvec3 levels) {
  const glm::dvec3 color = 255.0 * space.to_srgb(components);
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(color[i], levels[i], 0.56) << testing::PrintToString(components) << " " << i;
}

// The levels in the tests below are pixels that `pdftoppm` of poppler 22.12 paints for rectangles
// filled with these colours.

TEST(PdfColor, device_spaces) {
  expect_levels(ColorSpace::device_gray(), {0.3}, {77, 77, 77});
  expect_levels(ColorSpace::device_rgb(), {0.2, 0.5, 0.8}, {51, 128, 204});
  EXPECT_EQ(ColorSpace::device_gray().components(), 1);
  EXPECT_EQ(ColorSpace::device_rgb().components(), 3);
  EXPECT_EQ(ColorSpace::device_cmyk().components(), 4);
  EXPECT_EQ(ColorSpace::device_cmyk().ranges(), Ranges(4, {0, 1}));
}

TEST(PdfColor, cmyk) {
  const ColorSpace cmyk = ColorSpace::device_cmyk();
  const glm::dvec3 corners[] = {{255, 255, 255}, {35, 31, 32}, {255, 242, 0}, {28, 26, 0},
                                {236, 0, 140},   {36, 0, 0},   {237, 28, 36}, {34, 0, 0},
                                {0, 173, 239},   {0, 15, 36},  {0, 166, 80},  {0, 19, 0},
                                {46, 49, 146},   {0, 0, 2},    {54, 54, 57},  {0, 0, 0}};
  for (int i = 0; i < 16; ++i)
    expect_levels(cmyk, {1.0 * (i >> 3 & 1), 1.0 * (i >> 2 & 1), 1.0 * (i >> 1 & 1), 1.0 * (i & 1)},
                  corners[i]);
  expect_levels(cmyk, {0.1, 0.2, 0.3, 0.4}, {148, 127, 107});
  expect_levels(cmyk, {0.75, 0.68, 0.67, 0.9}, {16, 15, 13});
  expect_levels(cmyk, {0.5, 0, 1, 0.25}, {99, 159, 30});
  expect_levels(cmyk, {0, 0.35, 0.85, 0}, {249, 167, 43});
}

TEST(PdfColor, lab) {
  const ColorSpace d65 = ColorSpace::lab({});
  expect_levels(d65, {50, 20, -30}, {127, 109, 170});
  expect_levels(d65, {75, -60, 50}, {79, 210, 86});
  expect_levels(d65, {90, -10, 80}, {250, 229, 55});
  expect_levels(d65, {5, 0, 0}, {17, 17, 17});
  const ColorSpace d50 = ColorSpace::lab({{0.9642, 1, 0.8249}, {-100, 100}, {-100, 80}});
  EXPECT_EQ(d50.ranges(), (Ranges{{0, 100}, {-100, 100}, {-100, 80}}));
  expect_levels(d50, {100, 0, 0}, {255, 255, 255});
  expect_levels(d50, {50, 20, -30}, {133, 108, 170});
  expect_levels(d50, {75, -60, 50}, {59, 211, 83});
  expect_levels(d50, {90, -10, 80}, {240, 230, 50});
}

TEST(PdfColor, calibrated_spaces) {
  const glm::dvec3 gamma(1.8, 2.2, 2);
  const glm::dmat3 under_d65(0.4124, 0.2126, 0.0193, 0.3576, 0.7152, 0.1192, 0.1805, 0.0722,
                             0.9505);
  const glm::dmat3 under_d50(0.4361, 0.2225, 0.0139, 0.3851, 0.7169, 0.0971, 0.1431, 0.0606,
                             0.7142);
  expect_levels(ColorSpace::cal_rgb({{0.9505, 1, 1.089}, gamma, under_d65}), {0.2, 0.5, 0.8},
                {66, 128, 209});
  expect_levels(ColorSpace::cal_rgb({{0.9642, 1, 0.8249}, gamma, under_d50}), {0.2, 0.5, 0.8},
                {66, 128, 209});
  // poppler 22.12 gives greys a tint of the white point, against ISO 32000-1, 8.6.5.2: this is
  // 1.055 * 0.5^(2.2 / 2.4) - 0.055.
  expect_levels(ColorSpace::cal_gray(2.2), {0.5}, glm::dvec3(128.48));
}

TEST(PdfColor, profiles_count_as_device_spaces) {
  const auto same = [](const ColorSpace& space, const ColorSpace& device, const Numbers& color) {
    return space.components() == device.components() &&
           space.to_srgb(color) == device.to_srgb(color);
  };
  EXPECT_TRUE(same(ColorSpace::icc_based(1), ColorSpace::device_gray(), {0.3}));
  EXPECT_TRUE(same(ColorSpace::icc_based(3), ColorSpace::device_rgb(), {0.2, 0.5, 0.8}));
  EXPECT_TRUE(same(ColorSpace::icc_based(4), ColorSpace::device_cmyk(), {0.1, 0.2, 0.3, 0.4}));
  for (const int components : {-1, 0, 2, 5}) {
    EXPECT_THROW(ColorSpace::icc_based(components), InputError) << components;
  }
}

TEST(PdfColor, separations) {
  const ColorSpace cmyk = ColorSpace::device_cmyk();
  const Function tint(ExponentialFunction{{{0, 1}}, {}, {0, 0, 0, 0}, {0.9, 0.3, 0.7, 0.2}, 1.7});
  for (const char* const name : {"Spot", "All", "Black"}) {
    const ColorSpace space = ColorSpace::separation({name}, cmyk, tint);
    EXPECT_EQ(space.components(), 1);
    EXPECT_TRUE(space.paints());
    expect_levels(space, {0.6}, {148, 181, 163});
  }
  EXPECT_FALSE(ColorSpace::separation({"None"}, cmyk, tint).paints());
  const Function mixed(
      CalculatorFunction{{{0, 1}, {0, 1}}, Ranges(3), "{ 2 copy mul 1 exch sub }"});
  const ColorSpace two = ColorSpace::separation({"a", "None"}, ColorSpace::device_rgb(), mixed);
  EXPECT_TRUE(two.paints());
  expect_levels(two, {0.2, 0.5}, {51, 127.5, 229.5});
  EXPECT_FALSE(ColorSpace::separation({"None", "None"}, ColorSpace::device_rgb(), mixed).paints());

  EXPECT_THROW(ColorSpace::separation({}, cmyk, tint), InputError);
  EXPECT_THROW(ColorSpace::separation({"a", "b"}, cmyk, tint), InputError);
  EXPECT_THROW(ColorSpace::separation({"a", "b"}, cmyk, mixed), InputError);
  EXPECT_THROW(ColorSpace::separation({"a"}, two, tint), InputError);
}

TEST(PdfColor, oklab_of_typst) {
  // What Typst writes for gradients in Oklab, over linear sRGB as CalRGB.
  const Function tint(CalculatorFunction{
      Ranges(3), Ranges(3),
      "{ exch 0.5 sub exch 0.5 sub 2 index 2 index 2 index 0.2158037573 mul exch 0.3963377774 mul "
      "add add dup dup mul mul 3 index 3 index 3 index -0.0638541728 mul exch -0.1055613458 mul "
      "add "
      "add dup dup mul mul 4 index 4 index 4 index -1.2914855480 mul exch -0.0894841775 mul add "
      "add "
      "dup dup mul mul 6 3 roll pop pop pop 2 index 2 index 2 index 0.2309699292 mul exch "
      "-3.3077115913 mul add exch 4.0767416621 mul add 3 index 3 index 3 index -0.3413193965 mul "
      "exch 2.6097574011 mul add exch -1.2684380046 mul add 4 index 4 index 4 index 1.7076147010 "
      "mul "
      "exch -0.7034186147 mul add exch -0.0041960863 mul add 6 3 roll pop pop pop }"});
  const ColorSpace linear = ColorSpace::cal_rgb(
      {{0.9505, 1, 1.0888},
       glm::dvec3(1.0),
       glm::dmat3(0.4124, 0.2126, 0.0193, 0.3576, 0.715, 0.1192, 0.1805, 0.0722, 0.9505)});
  const ColorSpace oklab = ColorSpace::separation({"L", "A", "B"}, linear, tint);
  expect_levels(oklab, {1, 0.5, 0.5}, {255, 255, 255});
  // Oklab of sRGB's red.
  expect_levels(oklab, {0.62796, 0.72486, 0.62585}, {255, 0, 0});
}

TEST(PdfColor, components_of_any_kind_give_a_color) {
  const ColorSpace cmyk = ColorSpace::device_cmyk();
  expect_levels(cmyk, {-3, -infinite, not_a_number, 9}, {35, 31, 32});
  expect_levels(cmyk, {}, {255, 255, 255});
  expect_levels(cmyk, {0, 0, 0, 1, 7, 7}, {35, 31, 32});
  const glm::dmat3 large = glm::dmat3(max_pdf_number) * 2.0;
  const Numbers odd{0, 1, 0.5, -1e300, 1e300, 1e-300, infinite, -infinite, not_a_number};
  for (const ColorSpace& space :
       {cmyk, ColorSpace::lab({{1, 1, 1}, {-infinite, infinite}, {-1e300, 1e300}}),
        ColorSpace::cal_rgb({{1.2, 1, 0.6}, {1e-300, 1e38, 1}, large}), ColorSpace::cal_gray(1e38)})
    for (const double x : odd)
      for (const double y : odd)
        for (const double z : odd) {
          const glm::dvec3 color = space.to_srgb(Numbers{x, y, z, x});
          for (int k = 0; k < 3; ++k) ASSERT_TRUE(color[k] >= 0 && color[k] <= 1);
        }
}

TEST(PdfColor, parameters_that_make_no_space) {
  for (const glm::dvec3& white : {glm::dvec3(0.0), glm::dvec3(-1, 1, 1), glm::dvec3(1, 1, 1e30),
                                  glm::dvec3(not_a_number, 1, 1), glm::dvec3(0.01, 0.01, 900)}) {
    EXPECT_THROW(ColorSpace::lab({white, {-100, 100}, {-100, 100}}), InputError);
    EXPECT_THROW(ColorSpace::cal_rgb({white, glm::dvec3(1.0), glm::dmat3(1.0)}), InputError);
  }
  EXPECT_THROW(ColorSpace::lab({glm::dvec3(1.0), {100, -100}, {-100, 100}}), InputError);
  for (const double gamma : {0.0, -1.0, infinite, not_a_number}) {
    EXPECT_THROW(ColorSpace::cal_gray(gamma), InputError) << gamma;
    EXPECT_THROW(ColorSpace::cal_rgb({glm::dvec3(1.0), {1, gamma, 1}, glm::dmat3(1.0)}),
                 InputError);
  }
}

}  // namespace
}  // namespace gradmesh
