#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "formats/svg/tree/svg_tree.h"
#include "formats/svg/values/color.h"
#include "formats/svg/values/path.h"
#include "formats/svg/values/reference.h"
#include "formats/svg/values/shape.h"
#include "formats/svg/values/style.h"
#include "formats/svg/values/transform.h"
#include "formats/text/scanner.h"

namespace gradmesh {
namespace {

void expect_near(const glm::dvec2& a, const glm::dvec2& b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
}

void expect_box(std::string_view path, glm::dvec2 low, glm::dvec2 high, double tolerance = 1e-12) {
  SCOPED_TRACE(path);
  const auto box = path_box(path);
  ASSERT_TRUE(box && !box->empty());
  expect_near(box->low(), low, tolerance);
  expect_near(box->high(), high, tolerance);
}

// tests/python/inkscape/test_inkscape_reads.py holds them to what Inkscape paints.
TEST(SvgColor, all_forms) {
  const glm::dvec3 orange(1, 165 / 255.0, 0);
  for (const std::string_view text :
       {"orange", "ORANGE", "orange ham", "#ffa500", " #FFA500 ", "rgb(255,165,0)",
        " rgb( 255 , 165, 0 ) ", "#ffa500 icc-color(x, 1, 2)"})
    EXPECT_EQ(parse_color(text), orange) << text;
  EXPECT_EQ(parse_color("#f0a"), glm::dvec3(1, 0, 170 / 255.0));
  EXPECT_EQ(parse_color("rgb(100%, 50%, 0%)"), glm::dvec3(1, 0.5, 0));
  EXPECT_EQ(parse_color("rgb(300, -20, 0)"), glm::dvec3(1, 0, 0));
  EXPECT_EQ(parse_color("aliceblue"), glm::dvec3(240, 248, 255) / 255.0);
  EXPECT_EQ(parse_color("yellowgreen"), glm::dvec3(154, 205, 50) / 255.0);
}

void expect_color(std::string_view text, glm::dvec4 expected, double tolerance) {
  const auto color = parse_translucent_color(text);
  ASSERT_TRUE(color) << text;
  for (int i = 0; i < 4; ++i) EXPECT_NEAR((*color)[i], expected[i], tolerance) << text;
}

TEST(SvgColor, hsl) {
  expect_color("hsl(0, 100%, 50%)", {1, 0, 0, 1}, 1e-12);
  expect_color("hsl(120, 100%, 25%)", {0, 0.5, 0, 1}, 1e-12);
  expect_color("hsl(-120, 100%, 50%)", {0, 0, 1, 1}, 1e-12);
  // As Inkscape 1.5 writes it.
  expect_color("hsl(120, 100, 45.9)", {0, 0.918, 0, 1}, 1e-12);
  expect_color("hsl(47, 70, 30)", {0.51, 0.419, 0.09, 1}, 1e-12);
}

TEST(SvgColor, separators_and_opacities) {
  const glm::dvec4 half(1, 0, 0, 0.5);
  for (const std::string_view text :
       {"rgb(255 0 0 / 0.5)", "rgb(255 0 0/50%)", "rgba(255, 0, 0, 0.5)", "rgba(255 0 0 / .5)",
        "rgb(100% 0 0% / 50%)", "RGB(300, -1, none, 50%)", "hsla(0, 100%, 50%, .5)",
        "hsl(0 100 50 / 50%) ham", "hwb(0 0 0 / 0.5)", "color(srgb 1 0 0 / 0.5)",
        "color( SRGB 100% none 0% / 50% )", "device-cmyk(0 1 1 0 / 0.5)",
        "device-cmyk(0, 100%, 100%, 0, 50%)"})
    expect_color(text, half, 1e-12);
  expect_color("#f008", {1, 0, 0, 136 / 255.0}, 1e-12);
  expect_color("#FF000080", {1, 0, 0, 128 / 255.0}, 1e-12);
  expect_color("transparent", {0, 0, 0, 0}, 0);
  expect_color("rgb(1 2 3 / none)", {1 / 255.0, 2 / 255.0, 3 / 255.0, 0}, 1e-12);
  expect_color("rgb(0 0 0 / 7)", {0, 0, 0, 1}, 0);
  for (const std::string_view text : {"#f008", "rgba(1,2,3,0.99)", "transparent"})
    EXPECT_FALSE(parse_color(text)) << text;
  EXPECT_EQ(parse_color("#ff0000ff"), glm::dvec3(1, 0, 0));
  EXPECT_EQ(parse_color("rgba(255,0,0,1)"), glm::dvec3(1, 0, 0));
}

TEST(SvgColor, angles) {
  for (const std::string_view hue :
       {"90", "90deg", "450", "-270DEG", "0.25turn", "100grad", "1.5707963267948966rad", "25%"})
    expect_color("hsl(" + std::string(hue) + " 100 50)", {0.5, 1, 0, 1}, 1e-12);
}

// The expected values are those of matrices that were worked out anew, from the chromaticities of
// primaries and whites, and of Oklab's own for linear sRGB.
TEST(SvgColor, spaces_of_css_color_4) {
  const auto expect_opaque = [](std::string_view text, glm::dvec3 expected) {
    expect_color(text, glm::dvec4(expected, 1), 1e-4);
  };
  expect_opaque("hwb(150 20% 10%)", {0.2, 0.9, 0.55});
  expect_opaque("hwb(30 60 60)", {0.5, 0.5, 0.5});
  expect_opaque("lab(29.2345 39.3825 20.0664)", {0.49063, 0.13867, 0.15901});
  expect_opaque("lab(52.2345% 32.1316% 47.99768%)", {0.77617, 0.36339, 0.02455});
  expect_opaque("lab(5 -3 -4)", {0.028, 0.07302, 0.08943});
  expect_opaque("lch(29.2345% 44.2 27)", {0.49063, 0.13867, 0.15901});
  expect_opaque("lch(52.2345 48.13333% 56.2deg)", {0.77617, 0.36339, 0.02455});
  expect_opaque("oklab(0.40101 0.1147 0.0453)", {0.49055, 0.13874, 0.15913});
  expect_opaque("oklab(59.686%, 25.225%, 29.8%)", {0.77602, 0.36345, 0.02595});
  expect_opaque("oklch(0.7 0.15 40)", {0.9205, 0.47807, 0.32006});
  expect_opaque("oklch(40.1% 30.75% 21.57)", {0.49009, 0.13939, 0.15938});
  expect_opaque("color(srgb .4 .5 .6)", {0.4, 0.5, 0.6});
  expect_opaque("color(srgb-linear .2 .5 .8)", {0.48453, 0.73536, 0.90633});
  expect_opaque("color(display-p3 .4 50% .6)", {0.37282, 0.50367, 0.61006});
  expect_opaque("color(a98-rgb .4 .5 .6)", {0.34862, 0.50399, 0.60953});
  expect_opaque("color(prophoto-rgb .4 .5 .6)", {0.27102, 0.59139, 0.67821});
  expect_opaque("color(prophoto-rgb .02 .03 .03)", {0.0078, 0.02607, 0.02429});
  expect_opaque("color(rec2020 .4 .5 .6)", {0.36263, 0.55603, 0.65007});
  expect_opaque("color(rec2020 .04 .05 .06)", {0.08051, 0.10836, 0.12122});
  expect_opaque("color(xyz .3 .25 .2)", {0.72755, 0.46908, 0.45786});
  expect_opaque("color(xyz-d65 .3 .25 .2)", {0.72755, 0.46908, 0.45786});
  expect_opaque("color(xyz-d50 .3 .25 .2)", {0.69277, 0.47556, 0.53255});
  expect_opaque("device-cmyk(0.5 0.2 0 0.1)", {0.45, 0.72, 0.9});
}

TEST(SvgColor, white_is_white_in_all_spaces) {
  for (const std::string_view text :
       {"hwb(77 100 0)", "lab(100 0 0)", "lch(100 0 77)", "oklab(1 0 0)", "oklch(100% 0 none)",
        "oklch(7 0 0)", "lab(700 0 0)", "color(srgb-linear 1 1 1)", "color(display-p3 1 1 1)",
        "color(a98-rgb 1 1 1)", "color(prophoto-rgb 1 1 1)", "color(rec2020 1 1 1)",
        "color(xyz 0.9504559 1 1.0890578)", "color(xyz-d50 0.9642957 1 0.8251046)",
        "device-cmyk(0 0 0 0)"})
    expect_color(text, glm::dvec4(1.0), 1e-5);
}

TEST(SvgColor, channels_outside_of_srgb_are_clipped) {
  expect_color("oklch(0.7 0.4 150)", {0, 0.83865, 0, 1}, 1e-4);
  expect_color("lch(60 100 30)", {1, 0.05319, 0.25322, 1}, 1e-4);
  expect_color("color(display-p3 0 1 0)", {0, 1, 0, 1}, 1e-12);
  // Inkscape 1.5's own tests have this one.
  expect_color("lch(100 150 360)", {1, 0, 1, 1}, 1e-12);
  for (const std::string_view text :
       {"lab(1e9 1e9 -1e9)", "lch(50 -1e9 1e9)", "oklab(-1e9 1e9 1e9)", "oklch(1 1e9 1e9turn)",
        "color(rec2020 1e9 -1e9 1e9)", "color(xyz-d50 -1e9 1e9 1e9)", "hwb(1e9 1e9 1e9)"})
    EXPECT_TRUE(parse_color(text)) << text;
}

TEST(SvgColor, others_are_none) {
  for (const std::string_view text : {"",
                                      "#",
                                      "#12",
                                      "#12345",
                                      "#1234567",
                                      "#123456789",
                                      "#ggg",
                                      "#-12",
                                      "puce",
                                      "none",
                                      "rgb",
                                      "rgb (1,2,3)",
                                      "rgb()",
                                      "rgb(1,2)",
                                      "rgb(1,2,3",
                                      "rgb(1,,2,3)",
                                      "rgb(1 2 3 4)",
                                      "rgb(1,2,3,)",
                                      "rgb(1,2,3,4,5)",
                                      "rgb(1 2 3 / )",
                                      "rgb(1deg 2 3)",
                                      "rgb(nan,0,0)",
                                      "rgb(1e99,0,0)",
                                      "hsl(1em 2 3)",
                                      "hsl(1 2deg 3)",
                                      "hsl(1 deg 2 3)",
                                      "rgb(1 % 2 3)",
                                      "lab(ham 2 3)",
                                      "color(1 2 3)",
                                      "color(ham 1 2 3)",
                                      "color(lab 1 2 3)",
                                      "color(srgb 1 2)",
                                      "srgb(1 2 3)",
                                      "device-cmyk(1 2 3)",
                                      "icc-color(x, 1, 2)",
                                      "var(--x)",
                                      "url(#m) magenta",
                                      "currentColor",
                                      "inherit"})
    EXPECT_FALSE(parse_translucent_color(text)) << text;
}

TEST(SvgColor, texts_that_hex_would_not_give_back) {
  for (const std::string_view text :
       {"hsl(120, 100, 45.9)", "oklch(0.7 0.15 40 / 50%)", "rgb(1,2,3)", "#12345678", "#1234",
        "#ffa500 icc-color(x, 1, 2)"}) {
    EXPECT_EQ(own_color_text(text), text);
    EXPECT_EQ(own_color_text(" " + std::string(text) + " ham "), text);
  }
  for (const std::string_view text :
       {"", "red", "transparent", "#123", "#123456", "#123456 ham", "ham", "lab(1 2)", "#12345",
        "#ffa500 icc-color(;, 1)", "#ffa500 icc-color(x, 1"})
    EXPECT_EQ(own_color_text(text), "") << text;
}

TEST(SvgNumber, forms_and_limits) {
  const auto parse_number = [](std::string_view text) {
    Scanner scanner(text);
    const auto value = scanner.number();
    return scanner.at_end() ? value : std::nullopt;
  };
  for (const auto& [text, value] :
       std::vector<std::pair<std::string_view, double>>{{"1", 1},
                                                        {" -1.5 ", -1.5},
                                                        {"+.5", 0.5},
                                                        {"-.5e1", -5},
                                                        {"2E2", 200},
                                                        {"1.", 1},
                                                        {"1e-999", 0},
                                                        {"-1e9", -1e9}})
    EXPECT_EQ(parse_number(text), value) << text;
  for (const std::string_view text : {"", "-", "+-1", "-+1", ".", "nan", "-inf", "infinity", "1e30",
                                      "1e999", "1,5", "0x10", "1 2"})
    EXPECT_FALSE(parse_number(text)) << text;
}

TEST(SvgTransform, each_kind_and_order) {
  const auto map = [](std::string_view text) {
    const auto affine = parse_transform(text);
    EXPECT_TRUE(affine) << text;
    return affine.value_or(Affine{}).point({3, 5});
  };
  EXPECT_EQ(map(""), glm::dvec2(3, 5));
  EXPECT_EQ(map("matrix(1 2 3 4 5 6)"), glm::dvec2(23, 32));
  EXPECT_EQ(map("translate(10)"), glm::dvec2(13, 5));
  EXPECT_EQ(map("translate( 10 , -2 )"), glm::dvec2(13, 3));
  EXPECT_EQ(map("scale(2)"), glm::dvec2(6, 10));
  EXPECT_EQ(map("scale(2-1)"), glm::dvec2(6, -5));
  EXPECT_EQ(map("translate(10,20) , scale(2)scale(1 3)"), glm::dvec2(16, 50));
  expect_near(map("rotate(90)"), {-5, 3}, 1e-12);
  expect_near(map("rotate(90 3 4)"), {2, 4}, 1e-12);
  expect_near(map("skewX(45)"), {8, 5}, 1e-12);
  expect_near(map("skewY(45)"), {3, 8}, 1e-12);
  for (const std::string_view text :
       {"scale", "scale()", "scale(1 2 3)", "rotate(1 2)", "matrix(1 2 3 4 5)", "turn(1)",
        "scale(nan)", "scale(1", "translate(1px)", "(1)"})
    EXPECT_FALSE(parse_transform(text)) << text;
}

TEST(SvgTransform, is_finite) {
  std::string text;
  for (int i = 0; i < 34; ++i) text += "scale(1e9)";
  EXPECT_TRUE(parse_transform(text));
  EXPECT_FALSE(parse_transform(text + "scale(1000)"));
  EXPECT_FALSE(parse_transform(text + "translate(1000)"));
}

TEST(Affine, inverse_undoes) {
  const Affine map = parse_transform("rotate(30) skewX(10) translate(5 7) scale(2 -3)").value();
  expect_near((map.inverse() * map).point({3, 5}), {3, 5}, 1e-12);
  EXPECT_NEAR(map.determinant(), -6, 1e-12);
  expect_near(map.vector({1, 2}), map.point({4, 7}) - map.point({3, 5}), 1e-12);
}

TEST(SvgPath, box_of_every_command) {
  expect_box("M 1 2 L 5 7", {1, 2}, {5, 7});
  expect_box("m1 2 3 4-10-1", {-6, 2}, {4, 6});
  expect_box("M0 0H10V-3h-12v1z", {-2, -3}, {10, 0});
  expect_box("M0,0 C 0,4 4,4 4,0", {0, 0}, {4, 3});
  expect_box("M0,0 c 0,4 4,4 4,0 s 4-4 4 0", {0, -3}, {8, 3});
  expect_box("M0,0 S 4,4 4,0", {0, 0}, {4, 16 / 9.0});
  expect_box("M0,0 Q 2,4 4,0 t 4 0", {0, -2}, {8, 2});
  expect_box("M0 0 T 4 4", {0, 0}, {4, 4});
  expect_box("M 1 1 h 2 z m 5 5 h 1", {1, 1}, {7, 6});
  // The squares of these numbers are 0.
  EXPECT_NEAR(path_box("M 0 0 c 1e-201 4e-201 2e-201 4e-201 3e-201 0")->high().y, 3e-201, 1e-213);
  // A lone moveto draws nothing.
  expect_box("M -50 -50 M 1 1 h 2", {1, 1}, {3, 1});
  EXPECT_TRUE(path_box("M 3 4")->empty());
  EXPECT_TRUE(path_box("  ")->empty());
  for (const std::string_view text :
       {"L 1 2", "1 2", "M 1", "M 0 0 X 1", "M 0 0 L 1 nan", "M 0 0 z 1", "M 0 0 A 1 1 0 2 0 5 5",
        "M 0 0 C 1 2 3 4 5", "M 0 0 h 1e30"})
    EXPECT_FALSE(path_box(text)) << text;
}

// An ellipse drawn from its own parameters, against the end-point form that path data has.
TEST(SvgPath, box_of_arcs_against_dense_sampling) {
  const glm::dvec2 center(7, -3), radii(5, 2);
  for (const double rotation : {0.0, 25.0, 90.0, 160.0, -70.0})
    for (const double begin : {0.1, 1.7, 3.3, 5.0})
      for (const double extent : {0.3, 1.5, 3.0, 4.0, 6.0, -0.7, -2.5, -5.5}) {
        const double phi = rotation * std::numbers::pi / 180;
        const auto at = [&](double angle) {
          const double x = radii.x * std::cos(angle), y = radii.y * std::sin(angle);
          return center + glm::dvec2(std::cos(phi) * x - std::sin(phi) * y,
                                     std::sin(phi) * x + std::cos(phi) * y);
        };
        glm::dvec2 low = at(begin), high = low;
        constexpr int samples = 20000;
        for (int i = 1; i <= samples; ++i) {
          const glm::dvec2 p = at(begin + extent * i / samples);
          low = glm::min(low, p);
          high = glm::max(high, p);
        }
        const glm::dvec2 from = at(begin), to = at(begin + extent);
        char path[300];
        std::snprintf(path, sizeof path, "M %.15g %.15g A 5 2 %g %d %d %.15g %.15g", from.x, from.y,
                      rotation, std::abs(extent) > std::numbers::pi, extent > 0, to.x, to.y);
        // The samples miss an extremum by at most radius * step^2 / 8.
        expect_box(path, low, high, 1e-7);
      }
}

TEST(SvgPath, a_large_arc_with_hardly_a_chord_is_the_ellipse) {
  for (const char* end : {"1e-7", "1e-150", "1e-196", "1e-300"}) {
    const auto box = path_box("M0 0a2 1 0 1 1 0 " + std::string(end));
    ASSERT_TRUE(box) << end;
    EXPECT_NEAR(box->size().x, 4, 1e-6) << end;
    EXPECT_NEAR(box->size().y, 2, 1e-6) << end;
  }
}

// Whose centre is so far away that it has no digits left for them.
TEST(SvgPath, short_and_flat_arcs_are_exact) {
  expect_box("M 0 0 A 1e9 1e9 0 0 1 1 0", {0, -1.25e-10}, {1, 0}, 1e-20);
  expect_box("M 0 0 A 1e9 1 0 0 0 0 1e-8", {-1.25e-8, 0}, {0, 1e-8}, 1e-20);
}

TEST(SvgPath, outlines_of_arcs_lie_in_their_boxes) {
  std::mt19937_64 random(5);
  const auto upto = [&](double most) {
    return std::uniform_real_distribution<double>(0, most)(random);
  };
  const auto number = [&] {
    const double size = upto(5) < 1 ? 0 : std::pow(10, -320 + upto(329));
    return upto(2) < 1 ? size : -size;
  };
  for (int i = 0; i < 20000; ++i) {
    char path[300];
    std::snprintf(path, sizeof path, "M %.17g %.17g %c %.17g %.17g %.17g %d %d %.17g %.17g",
                  number(), number(), i % 2 ? 'a' : 'A', number(), number(), upto(360), i / 2 % 2,
                  i / 4 % 2, number(), number());
    const auto box = path_box(path);
    ASSERT_TRUE(box) << path;
    const glm::dvec2 low = box->low(), high = box->high();
    const double size =
        std::max({std::abs(low.x), std::abs(low.y), std::abs(high.x), std::abs(high.y)});
    ASSERT_TRUE(std::isfinite(size)) << path;
    const double rounding = std::max(1e-12 * size, std::numeric_limits<double>::min());
    const Outline outline = path_outline(path).value();
    for (const glm::dvec2 p : outline.front())
      ASSERT_TRUE(glm::all(glm::greaterThanEqual(p, low - rounding)) &&
                  glm::all(glm::lessThanEqual(p, high + rounding)))
          << path;
  }
}

TEST(SvgPath, arcs_that_are_none) {
  // Radii too small are stretched to a half circle; none at all make a line; flags may stick.
  expect_box("M 0 0 A 1 1 0 0 1 10 0", {0, -5}, {10, 0});
  expect_box("M0 0a1 1 0 0110 0", {0, -5}, {10, 0});
  expect_box("M 0 0 A 0 5 0 0 1 10 2", {0, 0}, {10, 2});
  expect_box("M 1 2 A 5 5 0 1 1 1 2", {1, 2}, {1, 2});
}

TEST(SvgShape, box_of_every_shape) {
  const auto expect_shape = [](const std::string& shape, glm::dvec2 low, glm::dvec2 high) {
    const SvgTree document =
        SvgTree::parse("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 400 300'><" + shape +
                           " id='a'/></svg>",
                       "drawing.svg");
    const auto box = shape_box(document.find("a"));
    ASSERT_TRUE(box) << shape;
    expect_near(box->low(), low, 1e-12);
    expect_near(box->high(), high, 1e-12);
  };
  expect_shape("rect x='1' y='2' width='30' height='4' rx='2'", {1, 2}, {31, 6});
  expect_shape("rect width='50%' height='10%'", {0, 0}, {200, 30});
  expect_shape("rect width='1in' height='3pc'", {0, 0}, {96, 48});
  expect_shape("circle cx='5' cy='6' r='2'", {3, 4}, {7, 8});
  expect_shape("ellipse cx='5' cy='6' rx='2' ry='3'", {3, 3}, {7, 9});
  expect_shape("ellipse cx='5' cy='6' rx='auto' ry='3'", {2, 3}, {8, 9});
  expect_shape("line x1='9' y1='1' y2='4'", {0, 1}, {9, 4});
  expect_shape("polygon points='1,2 3,-4,5 6'", {1, -4}, {5, 6});
  expect_shape("polyline points='1 2 3 4'", {1, 2}, {3, 4});
  expect_shape("path d='M 1 2 h 3 v 4'", {1, 2}, {4, 6});
}

double area(const Outline& outline) {
  double twice = 0;
  for (const auto& polygon : outline)
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const glm::dvec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
      twice += a.x * b.y - b.x * a.y;
    }
  return twice / 2;
}

void expect_area(std::string_view path, double expected, std::size_t polygons = 1) {
  SCOPED_TRACE(path);
  const auto outline = path_outline(path);
  ASSERT_TRUE(outline);
  EXPECT_EQ(outline->size(), polygons);
  EXPECT_NEAR(area(*outline), expected, 1e-3 * std::abs(expected));
}

TEST(SvgPath, outlines) {
  expect_area("M0,0 H4 V3 H0 Z", 12);
  expect_area("m1,1 h4 v3 h-4 z m10,0 h1 v1 h-1 z", 13, 2);
  // What follows a closed subpath without a moveto starts where that began.
  expect_area("M0,0 H4 V3 H0 Z L-2,0 -2,-2 0,-2", 12 + 4, 2);
  expect_area("M-2,0 A2,2 0 0 1 2,0 A2,2 0 0 1 -2,0 Z", 4 * std::numbers::pi);
  expect_area("M-2,0 A2,1 0 1 0 2,0 A2,1 0 1 0 -2,0", -2 * std::numbers::pi);
  // Under a cubic with these handles lies 3/5 of the box, under a quadratic 2/3.
  expect_area("M0,0 C0,-1 1,-1 1,0 Z", 0.6);
  expect_area("M0,0 Q0.5,-2 1,0 Z", 2.0 / 3);
  EXPECT_EQ(path_outline("M3,3")->size(), 0u);
  EXPECT_FALSE(path_outline("M0,0 L1"));
}

TEST(SvgShape, outlines) {
  const SvgTree document = SvgTree::parse(
      "<svg xmlns='http://www.w3.org/2000/svg'><rect id='r' x='1' y='2' width='4' "
      "height='3'/><rect id='round' width='4' height='3' rx='1'/><circle id='c' cx='9' "
      "r='2'/><ellipse id='e' rx='3' ry='2'/><polygon id='p' points='0,0 4,0 0,3'/><path id='d' "
      "d='M0,0h2v2z'/><text id='t'>a</text><line id='l' x2='3'/></svg>",
      "test");
  const auto size = [&](const char* id) {
    const auto outline = shape_outline(document.find(id));
    return outline ? area(*outline) : -1;
  };
  const double pi = std::numbers::pi;
  EXPECT_NEAR(size("r"), 12, 1e-9);
  EXPECT_NEAR(size("round"), 12 - 4 + pi, 1e-3);
  EXPECT_NEAR(size("c"), 4 * pi, 1e-3);
  EXPECT_NEAR(size("e"), 6 * pi, 1e-3);
  EXPECT_NEAR(size("p"), 6, 1e-9);
  EXPECT_NEAR(size("d"), 2, 1e-9);
  EXPECT_EQ(size("t"), -1);
  EXPECT_EQ(size("l"), -1);
}

using Id = std::optional<std::string>;

TEST(SvgReference, leads_where_inkscape_follows_it) {
  const auto id = [](std::string_view value) {
    return referenced_id(value, "/home/a b/own 1.svg");
  };
  for (const char* const value :
       {"url(#m)", "url( #m )", "url (#m)", "url('#m')", "url(\"#m\") red", "url(#%6d)",
        "url(own 1.svg#m)", "url(own%201.svg#m)", "url(./own%201.svg#m)",
        "url('/home/a b/own 1.svg#m')"})
    EXPECT_EQ(id(value), Id("m")) << value;
  EXPECT_EQ(id("url(#a%20b)"), Id("a b"));
  EXPECT_EQ(id("url(#a b)"), Id("a b"));
  EXPECT_EQ(id("url(' #m')"), std::nullopt);
  for (const char* const value : {"URL(#m)", "url(#m", "url(m)", "url(#)", "url(other.svg#m)",
                                  "url(#a%2)", "url(#a%zz)", "red", ""})
    EXPECT_EQ(id(value), std::nullopt) << value;
}

TEST(SvgReference, a_style_holds_no_odd_letters_without_quotes) {
  const auto fill = [](const std::string& style) {
    const SvgTree tree = SvgTree::parse(
        "<svg xmlns=\"http://www.w3.org/2000/svg\"><rect id=\"r\" "
        "fill=\"red\" style=\"" +
            style + "\"/></svg>",
        "test");
    return tree.styles().declared(tree.find("r"), "fill").value_or("");
  };
  const auto url = [](const std::string& letter) { return "url(#a" + letter + "b)"; };
  for (const char* const letter : {"\xc2\x80", "\xc2\xa0", "\xc2\xb1", "(", "'"}) {
    EXPECT_EQ(fill("fill:" + url(letter)), "red") << letter;
    EXPECT_EQ(fill("fill:blue;fill:" + url(letter)), "blue") << letter;
    EXPECT_TRUE(parse_style_rules(".a{fill:" + url(letter) + ";opacity:1}").empty()) << letter;
  }
  for (const char* const letter : {"\xc2\xb2", "\xc3\xa4", "\xe2\x82\xac", " ", ";", "."})
    EXPECT_EQ(fill("fill:" + url(letter)), url(letter)) << letter;
  EXPECT_EQ(fill("fill:url('#a\xc2\xa0')"), "url('#a\xc2\xa0')");
}

TEST(SvgStyle, what_is_left_open_does_not_swallow_what_is_written_behind_it) {
  const auto read = [](std::string_view text) { return parse_declarations(text); };
  EXPECT_EQ(read("fill:red;font:'a;b"), (Declarations{{"fill", "red"}, {"font", "'a;b'"}}));
  EXPECT_EQ(read("fill:url(\"#m"), (Declarations{{"fill", "url(\"#m\")"}}));
  EXPECT_EQ(read("fill:red\\"), (Declarations{{"fill", "red\\\\"}}));
  EXPECT_EQ(read("fill:red;'stroke:blue;"), (Declarations{{"fill", "red"}}));
  EXPECT_EQ(read("fill:re<!--d"), (Declarations{{"fill", "re d"}}));
}

}  // namespace
}  // namespace gradmesh
