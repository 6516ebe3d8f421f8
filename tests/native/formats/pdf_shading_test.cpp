#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <random>

#include <cmath>
#include <limits>

#include "base/error.h"
#include "formats/pdf/shading/read_patches.h"
#include "formats/pdf/shading/read_triangles.h"
#include "formats/pdf/shading/triangle_fan.h"
#include "shading_bits.h"

namespace gradmesh {
namespace {

/// Coordinates 0..255 of 8 bits, one component of 8 bits, flags of 8 bits.
Packing bytes() { return {8, 8, 8, {0, 255}, {0, 255}, {{0, 255}}}; }

Packing with_bits(int coordinate, int component, int flag) {
  Packing packing = bytes();
  packing.coordinate_bits = coordinate;
  packing.component_bits = component;
  packing.flag_bits = flag;
  return packing;
}

/// The outer points of a patch that is a square of 9 with its first corner at (x, 0), clockwise
/// with y down, first along v.
void add_square(BitWriter& data, std::uint32_t x) {
  for (const std::uint32_t step : {0U, 3U, 6U, 9U}) data.add({x, step}, 8);
  for (const std::uint32_t step : {3U, 6U, 9U}) data.add({x + step, 9}, 8);
  for (const std::uint32_t step : {6U, 3U, 0U}) data.add({x + 9, step}, 8);
  for (const std::uint32_t step : {6U, 3U}) data.add({x + step, 0}, 8);
}

ShadingPatches coons(const BitWriter& data, const Packing& packing = bytes()) {
  return read_patches(data.bytes(), packing, PatchKind::coons, 1000);
}

TEST(BitReader, ReadsAcrossBytesAndNotBeyondTheEnd) {
  BitReader bits("\xA5\x0F\x80");
  EXPECT_EQ(bits.read(3), 5U);
  EXPECT_EQ(bits.read(12), 0x50F >> 1 & 0xFFF);
  bits.align();
  EXPECT_EQ(bits.left(), 8U);
  EXPECT_EQ(bits.read(9), std::nullopt);
  EXPECT_EQ(bits.read(8), 0x80U);
  EXPECT_EQ(bits.read(1), std::nullopt);
}

TEST(BitReader, ThirtyTwoBitsHaveNoSign) {
  EXPECT_EQ(BitReader("\xFF\xFF\xFF\xFE").read(32), 0xFFFFFFFEU);
}

TEST(Shading, NumbersLieBetweenTheMinimumAndTheMaximum) {
  Packing packing = with_bits(32, 8, 8);
  packing.x = {-40000, 40000};
  packing.y = {10, 20};
  packing.components = {{0.25, 0.5}};
  BitWriter data;
  data.add({0xFFFFFFFFU, 0}, 32).add(255, 8);
  ShadingReader reader(data.bytes(), packing);
  EXPECT_EQ(reader.point(), glm::dvec2(40000, 10));
  EXPECT_EQ(reader.color(), Components{0.5});
}

TEST(Shading, TheLargestRangeHoldsNoInfinity) {
  Packing packing = bytes();
  const double most = std::numeric_limits<double>::max();
  packing.x = packing.y = {-most, most};
  ShadingReader reader(std::string_view("\x00\xFF", 2), packing);
  const auto point = reader.point();
  ASSERT_TRUE(point);
  EXPECT_TRUE(std::isfinite(point->x) && std::isfinite(point->y));
}

TEST(Shading, PackingsThatTheFormatDoesNotKnowAreRefused) {
  EXPECT_NO_THROW(check(bytes(), true));
  EXPECT_NO_THROW(check(with_bits(24, 12, 0), false));
  EXPECT_THROW(check(with_bits(24, 12, 0), true), InputError);
  EXPECT_THROW(check(with_bits(7, 8, 8), true), InputError);
  EXPECT_THROW(check(with_bits(64, 8, 8), true), InputError);
  EXPECT_THROW(check(with_bits(8, 32, 8), true), InputError);
  Packing packing = bytes();
  packing.components.clear();
  EXPECT_THROW(check(packing, true), InputError);
  packing = bytes();
  packing.y[1] = std::numeric_limits<double>::infinity();
  EXPECT_THROW(check(packing, true), InputError);
}

TEST(Shading, ACoonsPatchGetsItsInnerPoints) {
  BitWriter data;
  data.add(0, 8);
  add_square(data, 10);
  data.add({1, 2, 3, 4}, 8);
  const ShadingPatches read = coons(data);
  ASSERT_EQ(read.patches.size(), 1U);
  EXPECT_FALSE(read.is_damaged);
  const ShadingPatch& patch = read.patches.front();
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      EXPECT_NEAR(patch.net()[i][j].x, 10 + 3.0 * double(i), 1e-12);
      EXPECT_NEAR(patch.net()[i][j].y, 3.0 * double(j), 1e-12);
    }
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(patch.colors[k], Components{double(k + 1)});
}

TEST(Shading, InnerPointsOfATensorPatchComeAroundItToo) {
  BitWriter data;
  data.add(0, 8);
  add_square(data, 0);
  data.add({41, 42, 51, 52, 61, 62, 71, 72}, 8).add({1, 2, 3, 4}, 8);
  const auto patch = read_patches(data.bytes(), bytes(), PatchKind::tensor, 1000).patches.at(0);
  EXPECT_EQ(patch.net()[1][1], glm::dvec2(41, 42));
  EXPECT_EQ(patch.net()[1][2], glm::dvec2(51, 52));
  EXPECT_EQ(patch.net()[2][2], glm::dvec2(61, 62));
  EXPECT_EQ(patch.net()[2][1], glm::dvec2(71, 72));
}

/// A patch that continues at each side has that side and its two colours, and in the flag only the
/// low two bits count.
class ContinuedPatch : public testing::TestWithParam<int> {};

TEST_P(ContinuedPatch, SharesASide) {
  const std::size_t side = std::size_t(GetParam());
  BitWriter data;
  data.add(0, 8);
  add_square(data, 20);
  data.add({1, 2, 3, 4}, 8).add(0xFC | unsigned(side), 8);
  for (std::uint32_t n = 0; n < 8; ++n) data.add({100 + n, 200 + n}, 8);
  data.add({7, 8}, 8);
  const ShadingPatches read = coons(data);
  ASSERT_EQ(read.patches.size(), 2U);
  const auto a = read.patches[0].net(), b = read.patches[1].net();
  const std::array<std::array<glm::dvec2, 4>, 4> sides{{{a[0][0], a[0][1], a[0][2], a[0][3]},
                                                        {a[0][3], a[1][3], a[2][3], a[3][3]},
                                                        {a[3][3], a[3][2], a[3][1], a[3][0]},
                                                        {a[3][0], a[2][0], a[1][0], a[0][0]}}};
  for (std::size_t n = 0; n < 4; ++n) EXPECT_EQ(b[0][n], sides[side][n]);
  EXPECT_EQ(b[1][3], glm::dvec2(100, 200));
  EXPECT_EQ(b[1][0], glm::dvec2(107, 207));
  const auto& colors = read.patches[1].colors;
  EXPECT_EQ(colors[0], read.patches[0].colors[side]);
  EXPECT_EQ(colors[1], read.patches[0].colors[(side + 1) % 4]);
  EXPECT_EQ(colors[2], Components{7.0});
  EXPECT_EQ(colors[3], Components{8.0});
}

INSTANTIATE_TEST_SUITE_P(Sides, ContinuedPatch, testing::Values(1, 2, 3));

TEST(Shading, APatchIsTheSameSurfaceHoweverItIsListed) {
  ShadingPatch patch;
  for (std::size_t n = 0; n < 12; ++n) patch.outer[n] = {double(n), double(n * n)};
  for (std::size_t k = 0; k < 4; ++k) {
    patch.inner[k] = {100.0 + double(k), 0};
    patch.colors[k] = {double(k)};
  }
  const auto net = patch.net(), turned = patch.turned(1).net(), mirrored = patch.mirrored().net();
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      EXPECT_EQ(turned[i][j], net[j][3 - i]);
      EXPECT_EQ(mirrored[i][j], net[j][i]);
    }
  EXPECT_EQ(patch.turned(1).colors[0], Components{1.0});
  EXPECT_EQ(patch.mirrored().colors[1], Components{3.0});
  EXPECT_EQ(patch.turned(3).turned(1), patch);
  EXPECT_EQ(patch.mirrored().mirrored(), patch);
}

TEST(Shading, EachPatchBeginsWithAByte) {
  // 2 bits of a flag, 24 numbers and 4 colours of 4 bits each: 114 bits in 15 bytes.
  BitWriter data;
  for (const std::uint32_t value : {3U, 5U}) {
    data.add(0, 2);
    for (int n = 0; n < 28; ++n) data.add(value, 4);
    data.end();
  }
  Packing packing = with_bits(4, 4, 2);
  packing.x = packing.y = packing.components[0] = {0, 15};
  const ShadingPatches read = coons(data, packing);
  ASSERT_EQ(read.patches.size(), 2U);
  EXPECT_FALSE(read.is_damaged);
  EXPECT_EQ(read.patches[1].net()[3][3], glm::dvec2(5, 5));
  EXPECT_EQ(read.patches[1].colors[3], Components{5.0});
}

TEST(Shading, WhatLiesBeforeTheDamageIsRead) {
  BitWriter data;
  data.add(0, 8);
  add_square(data, 0);
  data.add({1, 2, 3, 4}, 8);
  const std::string whole = data.bytes();
  const auto read = [&](const std::string& data_bytes) {
    return read_patches(data_bytes, bytes(), PatchKind::coons, 1000);
  };
  EXPECT_FALSE(read(whole + "\r\n").is_damaged);
  EXPECT_TRUE(read(whole + std::string(20, '\0')).is_damaged);
  EXPECT_EQ(read(whole + std::string(20, '\0')).patches.size(), 1U);
  EXPECT_TRUE(read("\x01" + whole).is_damaged);
  EXPECT_TRUE(read("\x01" + whole).patches.empty());
  EXPECT_TRUE(read("").patches.empty());
  EXPECT_EQ(read_patches(whole + whole + whole, bytes(), PatchKind::coons, 2).patches.size(), 2U);
}

void add_vertex(BitWriter& data, std::uint32_t flag, std::uint32_t place) {
  data.add(flag, 8).add({place, place}, 8).add(place, 8);
}

std::vector<double> places(const ShadingTriangle& triangle) {
  return {triangle[0].place.x, triangle[1].place.x, triangle[2].place.x};
}

TEST(Shading, TrianglesKeepTwoVerticesOfTheOneBefore) {
  BitWriter data;
  // The flags of the second and third vertex of a new triangle count for nothing.
  add_vertex(data, 0, 1);
  add_vertex(data, 2, 2);
  add_vertex(data, 1, 3);
  add_vertex(data, 1, 4);
  add_vertex(data, 2, 5);
  const ShadingTriangles read = read_triangles(data.bytes(), bytes(), 1000);
  EXPECT_FALSE(read.is_damaged);
  ASSERT_EQ(read.triangles.size(), 3U);
  EXPECT_EQ(places(read.triangles[0]), (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(places(read.triangles[1]), (std::vector<double>{2, 3, 4}));
  EXPECT_EQ(places(read.triangles[2]), (std::vector<double>{2, 4, 5}));
  EXPECT_EQ(read.triangles[2][2].color, Components{5.0});
}

TEST(Shading, TrianglesThatContinueNothingAreDamage) {
  for (const std::uint32_t flag : {1U, 2U, 3U}) {
    BitWriter data;
    add_vertex(data, flag, 1);
    const ShadingTriangles read = read_triangles(data.bytes(), bytes(), 1000);
    EXPECT_TRUE(read.is_damaged && read.triangles.empty());
  }
}

TEST(Shading, WhatIsNotKeptIsCounted) {
  BitWriter triangles;
  for (std::uint32_t n = 0; n < 15; ++n) add_vertex(triangles, 0, n);
  const ShadingTriangles read = read_triangles(triangles.bytes(), bytes(), 2);
  EXPECT_EQ(read.triangles.size(), 2U);
  EXPECT_EQ(read.count, 5U);
  BitWriter lattice;
  for (std::uint32_t n = 0; n < 12; ++n) lattice.add({n, n, n}, 8);
  const ShadingLattice rows = read_lattice(lattice.bytes(), with_bits(8, 8, 0), 3, 7);
  EXPECT_EQ(rows.vertices.size(), 6U);
  EXPECT_EQ(rows.rows, 4U);
}

/// The four triangles of a cell, from whose first corner on it goes around.
std::array<ShadingTriangle, 4> cell_of(const std::array<ShadingVertex, 4>& corners,
                                       const ShadingVertex& middle) {
  std::array<ShadingTriangle, 4> triangles;
  for (std::size_t n = 0; n < 4; ++n) triangles[n] = {corners[n], corners[(n + 1) % 4], middle};
  return triangles;
}

const std::array<ShadingVertex, 4> corners{
    ShadingVertex{{0, 0}, {0}}, {{2, 0}, {10}}, {{2, 2}, {20}}, {{0, 2}, {10}}};
const std::vector<Packing::Range> levels{{0, 255}};

TEST(Shading, FourTrianglesAroundAPointAreACell) {
  const auto fan = fan_of(cell_of(corners, {{1, 1}, {10}}));
  ASSERT_TRUE(fan);
  EXPECT_EQ(fan->middle.place, glm::dvec2(1, 1));
  for (std::size_t n = 0; n < 4; ++n) EXPECT_EQ(fan->corners[n], corners[n]);
  EXPECT_TRUE(is_bilinear(*fan, levels));
}

TEST(Shading, TrianglesOfACellMayBeListedInAnyWay) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 100; ++trial) {
    auto triangles = cell_of(corners, {{1, 1}, {10}});
    std::ranges::shuffle(triangles, random);
    for (ShadingTriangle& triangle : triangles) std::ranges::shuffle(triangle, random);
    const auto fan = fan_of(triangles);
    ASSERT_TRUE(fan);
    EXPECT_EQ(fan->middle.place, glm::dvec2(1, 1));
    // Corners that follow one another share a side.
    for (std::size_t n = 0; n < 4; ++n)
      EXPECT_EQ(glm::distance(fan->corners[n].place, fan->corners[(n + 1) % 4].place), 2);
  }
}

TEST(Shading, ACellIsOnePatchWhereItsMiddleIsWhatCornersLetExpect) {
  EXPECT_TRUE(is_bilinear(*fan_of(cell_of(corners, {{1, 1}, {13}})), levels));
  EXPECT_FALSE(is_bilinear(*fan_of(cell_of(corners, {{1, 1}, {15}})), levels));
  EXPECT_FALSE(is_bilinear(*fan_of(cell_of(corners, {{1.2, 1}, {10}})), levels));
  // Between the corners and the middle a bilinear patch bends.
  auto bent = corners;
  bent[2].color = {100};
  EXPECT_FALSE(is_bilinear(*fan_of(cell_of(bent, {{1, 1}, {30}})), levels));
}

TEST(Shading, OtherTrianglesAreNoCell) {
  auto triangles = cell_of(corners, {{1, 1}, {10}});
  triangles[3][0].place = {7, 7};
  EXPECT_FALSE(fan_of(triangles));
  triangles = cell_of(corners, {{1, 1}, {10}});
  triangles[2] = triangles[1];
  EXPECT_FALSE(fan_of(triangles));
}

TEST(Shading, ALatticeHasWholeRows) {
  BitWriter data;
  for (std::uint32_t n = 0; n < 7; ++n) data.add({n, n, n}, 8);
  const ShadingLattice read = read_lattice(data.bytes(), with_bits(8, 8, 0), 3, 1000);
  EXPECT_EQ(read.columns, 3U);
  EXPECT_EQ(read.vertices.size(), 6U);
  EXPECT_TRUE(read.is_damaged);
  EXPECT_EQ(read.vertices[5].place, glm::dvec2(5, 5));
}

}  // namespace
}  // namespace gradmesh
