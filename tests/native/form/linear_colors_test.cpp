// Which meshes have the colours of a linear gradient (form/linear_colors.h).
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "form/linear_colors.h"
#include "meshes.h"

namespace gradmesh {
namespace {

using test::grid_parts;

constexpr double tolerance = 1e-6;

/// Gives each column of patches a colour at its left and one at its right, `lines[j]` between the
/// columns j - 1 and j.
MeshParts striped(int rows, const std::vector<glm::dvec4>& lines, std::uint32_t seed = 1) {
  std::mt19937 random(seed);
  const int columns = int(lines.size()) - 1;
  MeshParts parts = grid_parts({.rows = rows, .columns = columns}, random);
  for (int k = 0; k < rows * columns; ++k)
    for (const int i : {0, 3})
      for (const int j : {0, 3})
        parts.patches[std::size_t(k)].c[i][j].color = lines[std::size_t(k % columns + j / 3)];
  for (Patch& patch : parts.patches) make_color_bilinear(patch);
  return parts;
}

std::optional<LinearColors> found(const MeshParts& parts) {
  return linear_colors(build_mesh(parts), tolerance);
}

const glm::dvec4 red{1, 0, 0, 1}, white{1, 1, 1, 1}, blue{0, 0, 1, 1};

TEST(LinearColors, one_color_is_one_stop) {
  std::mt19937 random(3);
  MeshParts parts = grid_parts({.position_noise = 0.2}, random);
  for (Patch& patch : parts.patches)
    for (auto& row : patch.c)
      for (Value& value : row) value.color = glm::dvec4(0);
  for (Patch& patch : parts.patches) {
    for (const int i : {0, 3})
      for (const int j : {0, 3}) patch.c[i][j].color = {0.2, 0.4, 0.6, 0.8};
  }
  const auto colors = found(parts);
  ASSERT_TRUE(colors);
  ASSERT_EQ(colors->stops.size(), 1u);
  EXPECT_EQ(colors->stops[0].color, glm::dvec4(0.2, 0.4, 0.6, 0.8));
  parts.patches[4].c[3][3].color.b += 0.6 / 255;
  EXPECT_FALSE(found(parts));
}

/// The colours of the gradient are those of the mesh at any of its points, however it is turned.
TEST(LinearColors, are_those_of_the_mesh_everywhere) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const bool turned : {false, true})
    for (int trial = 0; trial < 20; ++trial) {
      MeshParts parts = striped(1 + trial % 3, {red, white, blue, red}, 11);
      const double angle = 6.3 * unit(random);
      transform(parts,
                {glm::dmat2(std::cos(angle), std::sin(angle), -std::sin(angle), std::cos(angle)),
                 {40 * unit(random), -70 * unit(random)}});
      if (turned)  // Rows become columns.
        for (Patch& patch : parts.patches)
          for (int i = 0; i < 4; ++i)
            for (int j = 0; j < i; ++j) std::swap(patch.c[i][j], patch.c[j][i]);
      if (turned) parts.curves.clear();
      const Mesh mesh = build_mesh(turned ? parts_of({{1, 1, {parts.patches[0]}}}) : parts);
      const auto colors = linear_colors(mesh, tolerance);
      ASSERT_TRUE(colors) << trial;
      const glm::dvec2 way = colors->end - colors->start;
      for (const Face f : mesh.faces()) {
        const Value value = mesh.patch(f).at(unit(random), unit(random));
        const double place = glm::dot(value.position - colors->start, way) / glm::dot(way, way);
        ASSERT_GE(place, -tolerance);
        ASSERT_LE(place, 1 + tolerance);
        std::size_t k = 1;
        while (k + 1 < colors->stops.size() && colors->stops[k].place < place) ++k;
        const auto &a = colors->stops[k - 1], &b = colors->stops[k];
        const glm::dvec4 expected =
            a.color + (place - a.place) / (b.place - a.place) * (b.color - a.color);
        EXPECT_LT(glm::distance(expected, value.color), 1e-5);
      }
    }
}

TEST(LinearColors, a_step_is_two_stops_at_one_place) {
  MeshParts parts = striped(2, {red, white, blue});
  for (const int k : {1, 3})
    for (const int i : {0, 3}) parts.patches[std::size_t(k)].c[i][0].color = red;
  for (Patch& patch : parts.patches) make_color_bilinear(patch);
  const auto colors = found(parts);
  ASSERT_TRUE(colors);
  ASSERT_EQ(colors->stops.size(), 4u);
  EXPECT_EQ(colors->stops[1].place, 0.5);
  EXPECT_EQ(colors->stops[1].color, white);
  EXPECT_EQ(colors->stops[2].place, 0.5);
  EXPECT_EQ(colors->stops[2].color, red);
}

TEST(LinearColors, are_not_those_of_other_meshes) {
  const std::vector<glm::dvec4> lines{red, white, blue};
  ASSERT_TRUE(found(striped(2, lines)));

  MeshParts other_color = striped(2, lines);
  other_color.patches[3].c[3][3].color = red;
  EXPECT_FALSE(found(other_color));

  MeshParts curved = striped(2, lines);
  curved.patches[0].c[1][0].position.x += 1;
  EXPECT_FALSE(found(curved));

  MeshParts uneven = striped(2, lines);
  uneven.patches[0].c[0][1].position.x += 1;
  EXPECT_FALSE(found(uneven));

  MeshParts bulging = striped(2, lines);
  bulging.patches[0].c[1][1].position.x += 1;
  EXPECT_FALSE(found(bulging));

  const glm::dvec4 half_white{1, 1, 1, 0.5};
  EXPECT_FALSE(found(striped(2, {red, half_white, blue})));
  EXPECT_TRUE(found(striped(2, {glm::dvec4(1, 0, 0, 0.5), half_white})));
}

/// A patch that turns back shows its colours twice.
TEST(LinearColors, do_not_turn_back) {
  MeshParts parts = striped(1, {red, white, blue});
  const Affine mirror{glm::dmat2(-1, 0, 0, 1), {200, 0}};
  transform(parts.patches[1], mirror);
  EXPECT_FALSE(found(parts));
}

}  // namespace
}  // namespace gradmesh
