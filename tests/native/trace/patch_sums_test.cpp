#include "trace/patch_sums.h"

#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <random>

#include "geom/cross.h"

namespace gradmesh {
namespace {

struct Case {
  ColoredQuad patch;
  TargetPicture target;
};

Case random_case(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> off(-4, 4), level(0, 255);
  Case c;
  c.target.width = 40;
  c.target.height = 30;
  c.target.is_opaque = seed % 2 == 0;
  for (int n = 0; n < c.target.width * c.target.height; ++n) {
    c.target.pixels.emplace_back(level(random), level(random), level(random),
                                 c.target.is_opaque ? 255 : level(random));
    if (seed % 3 == 0) c.target.weights.push_back(float(std::max(0.0, off(random)) / 4));
  }
  c.patch.places = {glm::dvec2(5, 5), {35, 5}, {35, 25}, {5, 25}};
  for (glm::dvec2& place : c.patch.places) place += glm::dvec2(off(random), off(random));
  // From a patch with hundreds of pixels to one with a few.
  const double size = 1.0 / double(1 + seed % 5);
  for (glm::dvec2& place : c.patch.places)
    place = glm::dvec2(20, 15) + size * (place - glm::dvec2(20, 15));
  for (glm::dvec4& color : c.patch.colors)
    for (int k = 0; k < 4; ++k) color[k] = level(random);
  return c;
}

/// The same as the formulas say it, pixel by pixel.
PatchSums plain_sums(const ColoredQuad& patch, const TargetPicture& target) {
  PatchSums sums;
  const auto& [p, c] = patch;
  const QuadMap map(p);
  const int channels = target.is_opaque ? 3 : 4;
  for_each_pixel(p, target.width, target.height, target.point, [&](int x, int y) {
    const glm::dvec2 at = map.parameters(glm::dvec2(x, y) + target.point);
    const double u = at.x, v = at.y;
    const double w[] = {(1 - u) * (1 - v), (1 - u) * v, u * v, u * (1 - v)};
    const glm::dvec2 by_u = map.by_u(v), by_v = map.by_v(u);
    const glm::dvec4 color_by_u = glm::mix(c[3] - c[0], c[2] - c[1], v);
    const glm::dvec4 color_by_v = glm::mix(c[1] - c[0], c[2] - c[3], u);
    const glm::dvec4 wanted(target.at(x, y));
    const glm::dvec4 d = w[0] * c[0] + w[1] * c[1] + w[2] * c[2] + w[3] * c[3] - wanted;
    for (int k = 0; k < channels; ++k) {
      const double alpha = wanted.a / 255,
                   weight = target.weight(x, y) * (k == 3 ? 1 : alpha * alpha);
      const glm::dvec2 slope = glm::dvec2(color_by_v[k] * by_u.y - color_by_u[k] * by_v.y,
                                          color_by_u[k] * by_v.x - color_by_v[k] * by_u.x) /
                               cross(by_v, by_u);
      const auto channel = std::size_t(k);
      sums.squares[channel] += weight * d[k] * d[k];
      for (std::size_t a = 0; a < 4; ++a) {
        sums.color_rhs[channel][a] -= w[a] * weight * d[k];
        for (int axis = 0; axis < 2; ++axis)
          sums.place_rhs[std::size_t(axis)][a] += w[a] * weight * d[k] * slope[axis];
        for (std::size_t b = 0; b <= a; ++b) {
          const std::size_t pair = PatchSums::pair(a, b);
          const double both = weight * w[a] * w[b];
          if (k == 0) sums.color[pair] += both;
          if (k == 3) sums.opacity[pair] += both;
          sums.place[0][pair] += both * slope.x * slope.x;
          sums.place[1][pair] += both * slope.x * slope.y;
          sums.place[2][pair] += both * slope.y * slope.y;
          for (int axis = 0; axis < 2; ++axis)
            sums.both[channel][std::size_t(axis)][pair] -= both * slope[axis];
        }
      }
    }
  });
  return sums;
}

template <std::size_t count>
void expect_near(const std::array<double, count>& found,
                 const std::array<double, count>& expected) {
  for (std::size_t n = 0; n < count; ++n)
    EXPECT_NEAR(found[n], expected[n], 1e-9 * (1 + std::abs(expected[n]))) << n;
}

template <class Inner, std::size_t count>
void expect_near(const std::array<Inner, count>& found, const std::array<Inner, count>& expected) {
  for (std::size_t n = 0; n < count; ++n) expect_near(found[n], expected[n]);
}

TEST(PatchSums, are_those_of_all_pixels) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    const Case c = random_case(seed);
    const PatchSums expected = plain_sums(c.patch, c.target);
    const PatchSums found = patch_sums(c.patch, c.target, Asked::all);
    expect_near(found.squares, expected.squares);
    expect_near(found.color_rhs, expected.color_rhs);
    expect_near(found.place_rhs, expected.place_rhs);
    expect_near(found.color, expected.color);
    expect_near(found.opacity, expected.opacity);
    expect_near(found.place, expected.place);
    expect_near(found.both, expected.both);
  }
}

TEST(PatchSums, of_less_are_the_same) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Case c = random_case(seed);
    const PatchSums all = patch_sums(c.patch, c.target, Asked::all);
    const PatchSums colors = patch_sums(c.patch, c.target, Asked::colors);
    EXPECT_EQ(colors.squares, all.squares);
    EXPECT_EQ(colors.color, all.color);
    EXPECT_EQ(colors.opacity, all.opacity);
    EXPECT_EQ(colors.color_rhs, all.color_rhs);
    EXPECT_EQ(patch_sums(c.patch, c.target, Asked::squares).squares, all.squares);
  }
}

TEST(PatchSums, of_no_pixel_are_nothing) {
  Case c = random_case(0);
  for (glm::dvec2& place : c.patch.places) place += 100.0;
  EXPECT_EQ(patch_sums(c.patch, c.target, Asked::all).squares, (std::array<double, 4>{}));
}

}  // namespace
}  // namespace gradmesh
