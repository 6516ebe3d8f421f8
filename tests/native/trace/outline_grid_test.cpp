#include "trace/outline_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "trace/line_fit.h"
#include "trace/traced_grid.h"

namespace gradmesh {
namespace {

/// An outline of which `radius` is the distance from the middle of 200 x 200 pixels by the angle.
Outline around_middle(const auto& radius) {
  std::vector<glm::dvec2> polygon;
  for (int k = 0; k < 720; ++k) {
    const double a = k * std::numbers::pi / 360;
    polygon.push_back(glm::dvec2(100) + radius(a) * glm::dvec2(std::cos(a), std::sin(a)));
  }
  return {polygon};
}

Outline ellipse() {
  return around_middle([](double a) { return 60 / std::hypot(std::cos(a), 0.7 * std::sin(a)); });
}
Outline lobes() {
  return around_middle([](double a) { return 70 + 12 * std::cos(3 * a) + 6 * std::sin(2 * a); });
}
const Outline square{{{40, 30}, {160, 30}, {160, 150}, {40, 150}}};

std::vector<glm::dvec2> border_of(const LineGrid& grid) {
  std::vector<glm::dvec2> border;
  for (int j = 0; j < grid.columns(); ++j) border.push_back(grid.knot(0, j).position);
  for (int i = 0; i < grid.rows(); ++i) border.push_back(grid.knot(i, grid.columns()).position);
  for (int j = grid.columns(); j > 0; --j) border.push_back(grid.knot(grid.rows(), j).position);
  for (int i = grid.rows(); i > 0; --i) border.push_back(grid.knot(i, 0).position);
  return border;
}

/// How far an outline is from the polygon around it, at the least, and below 0 where it is beyond.
double least_distance(const Outline& outline, const std::vector<glm::dvec2>& polygon) {
  double least = 1e9;
  for (const glm::dvec2 p : outline.front())
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const glm::dvec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
      const double share = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
      const double distance = glm::distance(p, a + share * (b - a));
      least = std::min(least, contains({{polygon}}, p) ? distance : -distance);
    }
  return least;
}

TEST(OutlineGrid, lies_closely_around_the_shape) {
  for (const Outline& outline : {ellipse(), lobes(), square})
    for (const auto& [rows, columns] : {std::pair(4, 4), {5, 3}, {7, 8}}) {
      const auto grid = outline_grid(outline, rows, columns, {200, 200});
      ASSERT_TRUE(grid) << rows << " x " << columns;
      EXPECT_FALSE(grid->folds());
      const double distance = least_distance(outline, border_of(*grid));
      EXPECT_GT(distance, 1);
      EXPECT_LT(distance, 4);
    }
}

TEST(OutlineGrid, begins_at_the_corners_of_what_has_some) {
  const auto grid = outline_grid(square, 3, 3, {200, 200});
  ASSERT_TRUE(grid);
  for (const auto& [row, column, corner] :
       {std::tuple(0, 0, glm::dvec2(40, 30)), {0, 3, {160, 30}}, {3, 3, {160, 150}}})
    EXPECT_LT(glm::distance(grid->knot(row, column).position, corner), 4);
}

TEST(OutlineGrid, is_the_same_whichever_way_the_outline_runs) {
  Outline other = lobes();
  std::ranges::reverse(other.front());
  const auto one = outline_grid(lobes(), 4, 4, {200, 200}),
             two = outline_grid(other, 4, 4, {200, 200});
  ASSERT_TRUE(one && two);
  for (int n = 0; n < one->points(); ++n)
    EXPECT_LT(glm::distance(one->knot(n).position, two->knot(n).position), 2);
}

TEST(OutlineGrid, is_none_of_what_has_no_area_or_would_fold) {
  EXPECT_FALSE(outline_grid({}, 4, 4, {200, 200}));
  EXPECT_FALSE(outline_grid({{{0, 0}, {50, 50}}}, 4, 4, {200, 200}));
  // A ring with a gap, around which a grid would lie over itself.
  std::vector<glm::dvec2> ring;
  for (const double radius : {90.0, 70.0})
    for (int k = 0; k <= 100; ++k) {
      const double a = 0.2 + (radius > 80 ? k : 100 - k) * 0.0588;
      ring.push_back(glm::dvec2(100) + radius * glm::dvec2(std::cos(a), std::sin(a)));
    }
  EXPECT_FALSE(outline_grid({ring}, 4, 4, {200, 200}));
}

TEST(OutlineGrid, keeps_its_border_while_it_is_traced) {
  TargetPicture target;
  target.width = target.height = 200;
  const FilledOutline shape{ellipse()};
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 200; ++x) {
      const float away = float(std::hypot(x - 80, y - 90));
      target.pixels.emplace_back(255 - away, 200 - 0.008f * away * away, 60, 255);
      target.weights.push_back(contains(shape, {x + 0.5, y + 0.5}) ? 1.0f : 0.0f);
    }
  const auto first = outline_grid(shape.outline, 4, 4, {200, 200});
  ASSERT_TRUE(first);
  StopWatch watch(0, {});
  const TracedGrid traced = traced_grid({{&target, *first}}, 64, watch);
  EXPECT_LT(std::sqrt(traced.squares / (3 * target.counted())), 1);
  EXPECT_GT(traced.grid.points(), first->points());
  EXPECT_FALSE(traced.grid.folds());
  const std::vector<glm::dvec2> border = border_of(*first), after = border_of(traced.grid);
  for (const glm::dvec2 p : after) EXPECT_LT(least_distance({{p}}, border), 1e-6);
  for (const glm::dvec2 p : border)
    EXPECT_TRUE(
        std::ranges::any_of(after, [&](glm::dvec2 q) { return glm::distance(p, q) < 1e-9; }));
}

}  // namespace
}  // namespace gradmesh
