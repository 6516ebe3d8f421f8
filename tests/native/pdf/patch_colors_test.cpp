#include "formats/pdf/page/patch_colors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <random>

#include "base/limits.h"

namespace gradmesh {
namespace {

constexpr double allowed = 4.0 / 255;

/// A patch of straight sides over the square of this size at a point: side 0 runs to the right at
/// the top, and its parameters are the shares of the square.
ShadingPatch square_patch(const std::array<Components, 4>& colors, glm::dvec2 at = {0, 0}) {
  static constexpr int around[12][2] = {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {3, 2},
                                        {3, 3}, {2, 3}, {1, 3}, {0, 3}, {0, 2}, {0, 1}};
  static constexpr int inside[4][2] = {{1, 1}, {2, 1}, {2, 2}, {1, 2}};
  ShadingPatch patch;
  const auto point = [&](const int(&n)[2]) { return at + glm::dvec2(n[0], n[1]) / 3.0; };
  for (std::size_t n = 0; n < 12; ++n) patch.outer[n] = point(around[n]);
  for (std::size_t k = 0; k < 4; ++k) patch.inner[k] = point(inside[k]);
  patch.colors = colors;
  return patch;
}

/// Returns the blend of four corners.
template <class Value>
Value bilinear(const std::array<Value, 4>& corners, double u, double v) {
  return (1 - u) * ((1 - v) * corners[0] + v * corners[1]) +
         u * ((1 - v) * corners[3] + v * corners[2]);
}

Components bilinear(const std::array<Components, 4>& corners, double u, double v) {
  Components blended;
  for (std::size_t n = 0; n < corners[0].size(); ++n)
    blended.push_back(
        bilinear<double>({corners[0][n], corners[1][n], corners[2][n], corners[3][n]}, u, v));
  return blended;
}

/// Returns how far the colours of parts of a square_patch() are from its own, at many places.
double largest_difference(const ShadingPatch& square, const ShadingColors& colors,
                          const std::vector<PagePatch>& parts) {
  double largest = 0;
  for (const PagePatch& part : parts) {
    const glm::dvec2 low = part.outer[0] - square.outer[0], size = part.outer[6] - part.outer[0];
    for (int n = 0; n < 17 * 17; ++n) {
      const glm::dvec2 share = glm::dvec2(n % 17, n / 17) / 16.0, at = low + share * size;
      const glm::dvec3 apart = glm::abs(glm::dvec3(bilinear(part.colors, share.y, share.x)) -
                                        colors.srgb(bilinear(square.colors, at.y, at.x)));
      largest = std::max({largest, apart.r, apart.g, apart.b});
    }
  }
  return largest;
}

/// The colours of a parameter between white and this one, by its power.
ShadingColors power_colors(double exponent) {
  return {ColorSpace::device_rgb(),
          Function(ExponentialFunction{{{0, 1}}, {}, {1, 1, 1}, {0, 0.5, 1}, exponent})};
}

/// The colours of a parameter with gray samples at regular places.
ShadingColors sampled_colors(const std::string& samples) {
  SampledFunction function{{{0, 1}}, {{0, 1}}, {int(samples.size())}, 8, {}, {}, samples};
  return {ColorSpace::device_gray(), Function(std::move(function))};
}

ShadingColors step_colors() {
  const Function black(ExponentialFunction{{{0, 1}}, {}, {0}, {0}, 1});
  const Function white(ExponentialFunction{{{0, 1}}, {}, {1}, {1}, 1});
  return {ColorSpace::device_gray(),
          Function(StitchingFunction{{{0, 1}}, {}, {black, white}, {0.3}, {{0, 1}, {0, 1}}})};
}

TEST(PatchColors, PatchesThatSufficeStayAsTheyAre) {
  const ShadingColors rgb(ColorSpace::device_rgb(), {});
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(0, 1);
  std::vector<ShadingPatch> patches;
  for (int n = 0; n < 50; ++n) {
    std::array<Components, 4> colors;
    for (Components& color : colors) color = {share(random), share(random), share(random)};
    patches.push_back(square_patch(colors, {n, 0}));
  }
  EXPECT_EQ(in_srgb(patches, rgb), corners_in_srgb(patches, rgb));
  const ShadingPatch close = square_patch({Components{0.5}, {0.52}, {0.54}, {0.5}});
  EXPECT_EQ(in_srgb({close}, power_colors(3)), corners_in_srgb({close}, power_colors(3)));
}

struct CurvedColors {
  const char* name;
  ShadingColors colors;
  std::array<Components, 4> corners;
};

std::vector<CurvedColors> curved_colors() {
  return {
      {"cmyk",
       {ColorSpace::device_cmyk(), {}},
       {{{1, 0, 0, 0}, {0, 0, 1, 0}, {0, 1, 0, 0}, {0, 0, 0, 1}}}},
      {"lab", {ColorSpace::lab({}), {}}, {{{85, -70, 60}, {45, 60, 50}, {90, 0, 0}, {20, 0, 0}}}},
      {"power", power_colors(2.5), {{{0}, {0.5}, {1}, {0.2}}}},
      {"saddle", power_colors(4), {{{0}, {1}, {0}, {1}}}},
      {"hue",
       sampled_colors(std::string("\x00\x40\x70\x90\xa0\xb0\xc0\xff", 8)),
       {{{0}, {1}, {0.5}, {0.1}}}}};
}

TEST(PatchColors, PartsAreAsCloseAsTheyHaveToBe) {
  for (const CurvedColors& each : curved_colors()) {
    const ShadingPatch patch = square_patch(each.corners);
    EXPECT_GT(largest_difference(patch, each.colors, corners_in_srgb({patch}, each.colors)),
              2 * allowed)
        << each.name;
    const auto parts = in_srgb({patch}, each.colors);
    // Between the points that decide, a kink of a function is off by a bit more.
    EXPECT_LE(largest_difference(patch, each.colors, parts), 1.1 * allowed) << each.name;
    EXPECT_LE(parts.size(), 200U) << each.name;
    double area = 0;
    for (const PagePatch& part : parts) {
      const glm::dvec2 size = part.outer[6] - part.outer[0];
      area += size.x * size.y;
      for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(part.colors[k].a, 1);
    }
    EXPECT_NEAR(area, 1, 1e-12) << each.name;
  }
}

/// Returns the place of a patch's surface.
glm::dvec2 surface(const PagePatch& patch, double u, double v) {
  const auto weights = [](double t) {
    const double s = 1 - t;
    return std::array{s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
  };
  const auto along_u = weights(u), along_v = weights(v);
  const auto net = patch.net();
  glm::dvec2 place(0.0);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) place += along_u[i] * along_v[j] * net[i][j];
  return place;
}

TEST(PatchColors, PartsLieOnThePatch) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> anywhere(-5, 5);
  for (const CurvedColors& each : curved_colors()) {
    const ShadingPatch square = square_patch(each.corners);
    ShadingPatch bent = square;
    for (glm::dvec2& point : bent.outer) point += glm::dvec2(anywhere(random), anywhere(random));
    for (glm::dvec2& point : bent.inner) point += glm::dvec2(anywhere(random), anywhere(random));
    const PagePatch whole = corners_in_srgb({bent}, each.colors)[0];
    // The parts of the square say which parts of the parameters they are.
    const auto shares = in_srgb({square}, each.colors), parts = in_srgb({bent}, each.colors);
    ASSERT_EQ(parts.size(), shares.size());
    for (std::size_t n = 0; n < parts.size(); ++n)
      for (const glm::dvec2 at : {glm::dvec2(0, 0), glm::dvec2(0.3, 0.8), glm::dvec2(1, 0.5)}) {
        const glm::dvec2 share = surface(shares[n], at.x, at.y);
        EXPECT_LT(glm::distance(surface(parts[n], at.x, at.y), surface(whole, share.y, share.x)),
                  1e-12);
      }
  }
}

TEST(PatchColors, OnlyTheDirectionAlongWhichTheyBendIsDivided) {
  const std::array<Components, 4> across{{{0}, {1}, {1}, {0}}}, down{{{0}, {0}, {1}, {1}}};
  for (const auto& colors : {across, down}) {
    const auto parts = in_srgb({square_patch(colors)}, power_colors(3));
    EXPECT_GT(parts.size(), 2U);
    for (const PagePatch& part : parts) {
      const glm::dvec2 size = part.outer[6] - part.outer[0];
      EXPECT_EQ(colors == across ? size.y : size.x, 1);
    }
  }
}

/// However each is listed, both divide a side that they share.
TEST(PatchColors, NeighboursAreDividedAtTheSamePlaces) {
  const Components a{0.1}, b{0.9};
  const ShadingPatch above = square_patch({a, b, b, a}), below = square_patch({a, b, b, a}, {0, 1});
  for (std::size_t turns = 0; turns < 4; ++turns)
    for (const ShadingPatch& listed : {below.turned(turns), below.turned(turns).mirrored()}) {
      std::map<double, std::vector<glm::dvec4>> colors;
      for (const PagePatch& part : in_srgb({above, listed}, power_colors(3)))
        for (std::size_t k = 0; k < 4; ++k)
          if (part.outer[3 * k].y == 1) colors[part.outer[3 * k].x].push_back(part.colors[k]);
      EXPECT_GT(colors.size(), 3U);
      for (const auto& [x, there] : colors) {
        // Of two parts above and two below.
        EXPECT_EQ(there.size(), x == 0 || x == 1 ? 2U : 4U);
        for (const glm::dvec4& color : there)
          EXPECT_LT(glm::distance(color, there[0]), 1e-12) << turns;
      }
    }
}

TEST(PatchColors, AStepIsHalvedFiveTimes) {
  const auto parts = in_srgb({square_patch({Components{0}, {1}, {1}, {0}})}, step_colors());
  EXPECT_EQ(parts.size(), 6U);
  double smallest = 1;
  for (const PagePatch& part : parts)
    smallest = std::min(smallest, part.outer[6].x - part.outer[0].x);
  EXPECT_EQ(smallest, 1.0 / 32);
  EXPECT_LE(in_srgb({square_patch({Components{0}, {1}, {0}, {1}})}, step_colors()).size(), 1024U);
}

TEST(PatchColors, StripesWithTheSameColoursAtTheQuartersAreSeen) {
  const ShadingColors stripes =
      sampled_colors(std::string("\x00\xff\x00\xff\x00\xff\x00\xff\x00", 9));
  const ShadingPatch patch = square_patch({Components{0}, {1}, {1}, {0}});
  EXPECT_LE(largest_difference(patch, stripes, in_srgb({patch}, stripes)), 1e-12);
}

TEST(PatchColors, PartsFollowOneAnotherAndHaveALimit) {
  std::string noise;
  std::mt19937 random(3);
  for (int n = 0; n < 4096; ++n) noise += char(random() % 256);
  const ShadingColors colors = sampled_colors(noise);
  std::vector<ShadingPatch> patches;
  constexpr std::size_t count = 60;
  for (std::size_t n = 0; n < count; ++n)
    patches.push_back(square_patch({Components{0}, {0.7}, {0.1}, {1}}, {double(n), 0}));
  const auto parts = in_srgb(patches, colors);
  EXPECT_LE(parts.size(), limits().patches);
  EXPECT_GT(parts.size(), limits().patches - 4);
  std::vector<std::size_t> counts(count);
  double last = 0;
  for (const PagePatch& part : parts) {
    const double at = std::floor((part.outer[0].x + part.outer[6].x) / 2);
    EXPECT_GE(at, last);
    last = at;
    ++counts.at(std::size_t(at));
  }
  // All have been halved four times before one is for the fifth time.
  for (const std::size_t n : counts) EXPECT_GE(n, 200U);
}

TEST(PatchColors, OpacitiesAreBlendedBetweenCorners) {
  const ShadingPatch patch = square_patch({Components{0}, {1}, {1}, {0}});
  const auto parts = in_srgb({patch, patch}, power_colors(3), {{0, 0.5, 1, 0.5}, {1, 1, 1, 1}});
  for (std::size_t n = 0; n < parts.size(); ++n)
    for (std::size_t k = 0; k < 4; ++k) {
      const glm::dvec2 at = parts[n].outer[3 * k];
      EXPECT_NEAR(parts[n].colors[k].a, n < parts.size() / 2 ? (at.x + at.y) / 2 : 1, 1e-12);
    }
}

}  // namespace
}  // namespace gradmesh
