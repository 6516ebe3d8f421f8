#include <gtest/gtest.h>

#include <random>

#include "corners.h"
#include "files/base64.h"
#include "formats/packed/expectation.h"
#include "formats/packed/patches.h"
#include "formats/packed/range_coder.h"
#include "formats/packed/scale.h"
#include "random_meshes.h"

namespace gradmesh {
namespace {

std::string random_bytes(std::size_t count, std::mt19937& random) {
  std::string bytes;
  while (bytes.size() < count) bytes += char(std::uint8_t(random()));
  return bytes;
}

PackedMesh random_grid(double step, glm::dvec2 place = {}) {
  std::mt19937 random(7);
  MeshParts parts = test::grid_parts(
      {.rows = 3, .columns = 4, .position_noise = 0.1, .color_noise = 0.3}, random);
  transform(parts, Affine::translation(place));
  for (Patch& patch : parts.patches) {
    BezierNet net = bezier_net(patch);
    for (auto& row : net)
      for (Value& value : row) value.position = glm::round(value.position / step) * step;
    patch = patch_from_bezier(net);
  }
  test::change_corners(parts, [](Value& v) { v.color = glm::round(v.color * 1000.0) / 1000.0; });
  return {.grids = {{3, 4, parts.patches}}};
}

double largest_difference(const PackedMesh& a, const PackedMesh& b) {
  double most = 0;
  for (std::size_t f = 0; f < a.grids[0].patches.size(); ++f)
    most = std::max(most, test::difference(a.grids[0].patches[f], b.grids[0].patches[f]));
  return most;
}

TEST(Base85, gives_all_bytes_back_as_characters_that_need_no_escape) {
  std::mt19937 random(1);
  for (std::size_t count = 0; count < 40; ++count) {
    const std::string bytes = random_bytes(count, random), text = base85(bytes);
    EXPECT_EQ(base85_bytes(text), bytes);
    EXPECT_EQ(text.size(), (5 * count + 3) / 4);
    EXPECT_EQ(text.find_first_of("&<>\"'\\~ "), text.npos);
  }
  EXPECT_EQ(base85_bytes(base85(std::string(4, '\xff'))), std::string(4, '\xff'));
}

TEST(Base85, refuses_what_it_has_not_written) {
  // Too large, alone, another character, and a last digit that is cut off but not the largest.
  for (const char* text : {"}}}}}", "0", "000000", "0000~", "00 00", "01"})
    EXPECT_EQ(base85_bytes(text), std::nullopt) << text;
}

TEST(RangeCoder, gives_bits_back_and_takes_few_bytes_where_they_are_likely) {
  for (const double share : {0.0, 0.01, 0.5, 0.99, 1.0}) {
    std::mt19937 random(2);
    std::bernoulli_distribution bit(share);
    std::vector<bool> bits(10000);
    for (auto&& b : bits) b = bit(random);
    RangeCoder writer;
    Chance chance;
    for (const bool b : bits) EXPECT_EQ(writer.code(b, chance), b);
    const std::string bytes = writer.finish();
    EXPECT_LT(bytes.size(), share == 0.5 ? 1300u : share == 0 || share == 1 ? 20u : 140u);
    RangeCoder reader(bytes);
    Chance again;
    for (const bool b : bits) ASSERT_EQ(reader.code(false, again), b);
    EXPECT_TRUE(reader.is_exhausted());
  }
}

/// A carry runs through bytes of 255, which a bit of nearly no share brings about.
TEST(RangeCoder, carries) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    std::mt19937 random(seed);
    RangeCoder writer;
    std::vector<bool> bits;
    for (int i = 0; i < 60; ++i) bits.push_back(i > 40 ? random() % 2 : random() % 40 == 0);
    for (const bool b : bits) writer.code(b);
    const std::string bytes = writer.finish();
    RangeCoder reader(bytes);
    for (const bool b : bits) ASSERT_EQ(reader.code(false), b) << "seed " << seed;
    EXPECT_TRUE(reader.is_exhausted());
  }
}

TEST(RangeCoder, tells_when_bytes_are_missing_or_left_over) {
  RangeCoder writer;
  Spread spread;
  for (std::int64_t n = 0; n < 50; ++n) spread.code(writer, n * n * n);
  const std::string bytes = writer.finish();
  for (const std::string& changed :
       {bytes.substr(0, bytes.size() - 1), bytes + 'x', std::string()}) {
    RangeCoder reader(changed);
    Spread again;
    for (int n = 0; n < 50; ++n) again.code(reader, 0);
    EXPECT_FALSE(reader.is_exhausted());
  }
}

TEST(Spread, gives_all_numbers_back) {
  std::vector<std::int64_t> numbers{0, 1, -1, INT64_MAX, -INT64_MAX, 1, 0};
  for (int bits = 0; bits < 63; ++bits)
    for (const std::int64_t n : {std::int64_t(1) << bits, -(std::int64_t(1) << bits) + 1})
      numbers.push_back(n);
  RangeCoder writer;
  Spread spread;
  for (const std::int64_t n : numbers) EXPECT_EQ(spread.code(writer, n), n);
  const std::string bytes = writer.finish();
  RangeCoder reader(bytes);
  Spread again;
  for (const std::int64_t n : numbers) EXPECT_EQ(again.code(reader, 0), n);
}

TEST(Expectation, is_the_guess_that_was_best_of_late) {
  const double none = std::nan("");
  Expectation<2> expectation;
  EXPECT_EQ(expectation.of({none, none}), 0);
  EXPECT_EQ(expectation.of({none, 7.4}), 7);
  for (int i = 0; i < 3; ++i) expectation.learn({100.0, 9.0}, 10);
  EXPECT_EQ(expectation.of({3.0, 5.0}), 5);
  for (int i = 0; i < 30; ++i) expectation.learn({10.0, 9.0}, 10);
  EXPECT_EQ(expectation.of({3.0, 5.0}), 3);
  expectation.learn({INFINITY, 9.0}, 10);
  for (int i = 0; i < 60; ++i) expectation.learn({10.0, 9.0}, 10);
  EXPECT_EQ(expectation.of({INFINITY, 5.0}), 0x1p52);
}

TEST(Scale, is_the_decimal_step_of_the_document) {
  for (const auto& [step, exponent] : {std::pair(0.001, -3), {0.01, -2}, {0.5, -1}, {1e-4, -4}}) {
    const Scale scale = scale_for(random_grid(step).grids, 22);
    for (const AxisStep& found : scale.steps) {
      EXPECT_TRUE(found.is_decimal);
      EXPECT_EQ(found.exponent, exponent);
    }
    EXPECT_EQ(scale.levels[0], 1000);
  }
  // Finer than what is asked for, and no decimal one.
  for (const double step : {1e-9, 1.0 / 3000})
    EXPECT_FALSE(scale_for(random_grid(step).grids, 22).steps[0].is_decimal);
}

TEST(Packed, keeps_the_very_numbers_of_a_document) {
  for (const double step : {1e-4, 0.001, 0.01, 0.5})
    for (const glm::dvec2 place : {glm::dvec2(0), glm::dvec2(500, -300)}) {
      const PackedMesh mesh = random_grid(step, place);
      const auto back = unpack(pack(mesh, 22));
      ASSERT_TRUE(back);
      EXPECT_LE(largest_difference(mesh, *back), 1e-11);
    }
}

TEST(Packed, keeps_curves_and_smoothness) {
  PackedMesh mesh = random_grid(0.01);
  mesh.smooth = true;
  mesh.curves = "3 | 17 0.25 20 0.5 30; 4 | 5\xff";
  const auto back = unpack(pack(mesh, 22));
  ASSERT_TRUE(back);
  EXPECT_TRUE(back->smooth);
  EXPECT_EQ(back->curves, mesh.curves);
}

TEST(Packed, does_not_become_much_of_few_bytes) {
  PackedMesh mesh = random_grid(0.01);
  mesh.curves = std::string(1 << 20, ' ');
  const std::string bytes = pack(mesh, 22);
  EXPECT_LT(bytes.size(), 10000u);
  EXPECT_FALSE(unpack(bytes));
  std::mt19937 random(3);
  for (int i = 0; i < 2000; ++i) unpack(random_bytes(random() % 400, random));
}

}  // namespace
}  // namespace gradmesh
