#include "trace/guided_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>

#include "base/parallel.h"
#include "trace/line_fit.h"
#include "trace/outline_grid.h"
#include "trace/thinned_grids.h"
#include "trace/traced_grid.h"

namespace gradmesh {
namespace {

using Line = std::vector<glm::dvec2>;

constexpr glm::dvec2 page(120, 90);

double edge_at(double x) { return 45 + 18 * std::sin(x / 24); }

/// Returns a picture of what is above and below the edge, by the distance from it.
TargetPicture along_edge(const auto& level_at) {
  TargetPicture target;
  target.width = int(page.x);
  target.height = int(page.y);
  for (int y = 0; y < target.height; ++y)
    for (int x = 0; x < target.width; ++x) {
      const double level = level_at(x, edge_at(x + 0.5) - y - 0.5);
      target.pixels.emplace_back(level, 0.8 * level, 200 - 0.5 * level, 255);
    }
  return target;
}

/// Two soft areas with a sharp edge between them.
TargetPicture two_areas() {
  return along_edge([](double x, double above) {
    return 60 + 0.4 * x + std::clamp(above + 0.5, 0.0, 1.0) * (90 - 0.5 * above);
  });
}

/// Two soft areas with a crease between them.
TargetPicture crease() {
  return along_edge(
      [](double x, double above) { return 60 + 0.4 * x + 2 * std::max(0.0, above) - 0.2 * above; });
}

/// The edge from one x to another.
Line edge(double from, double to) {
  Line line;
  for (double x = from; x < to; x += 1.5) line.emplace_back(x, edge_at(x));
  line.emplace_back(to, edge_at(to));
  return line;
}

double distance_to(const Guide& guide, glm::dvec2 place) {
  return glm::distance(place, guide.at(guide.nearest(place)));
}

struct Followed {
  Along along;
  int line, points;
  /// Between the first and the last point on the guide.
  double length, farthest_point, farthest_side;
};

/// Returns how a grid's line follows a guide, by number.
Followed followed(const LineGrid& grid, int number) {
  for (const Along along : {Along::rows, Along::columns})
    for (int line = 0; line <= grid.strips(along); ++line) {
      std::vector<int> on;
      for (int k = 0; k < grid.points_along(along); ++k)
        if (grid.knot(grid.number(along, line, k)).on_guide(along).guide == number) on.push_back(k);
      if (on.empty()) continue;
      const Guide& guide = grid.guides()[std::size_t(number)];
      const auto at = [&](int k) { return grid.knot(grid.number(along, line, k)); };
      Followed result{along, line, int(on.size()), 0, 0, 0};
      result.length =
          std::abs(at(on.back()).on_guide(along).way - at(on.front()).on_guide(along).way);
      for (int k = on.front(); k <= on.back(); ++k) {
        result.farthest_point = std::max(result.farthest_point, distance_to(guide, at(k).position));
        for (double share = 0; k < on.back() && share < 1; share += 0.1)
          result.farthest_side =
              std::max(result.farthest_side,
                       distance_to(guide, glm::mix(at(k).position, at(k + 1).position, share)));
      }
      return result;
    }
  return {Along::rows, -1, 0, 0, 1e9, 1e9};
}

TracedGrid traced(const TargetPicture& target, const std::vector<Line>& guides, int points) {
  std::vector<Beginning> beginnings;
  for (const LineGrid& grid : even_grids(target, page, points))
    beginnings.push_back({&target, guided_grid(grid, guides, points).grid});
  StopWatch watch(0, {});
  return traced_grid(beginnings, points, watch);
}

struct EdgeCase {
  TargetPicture target;
  int points;
};

TEST(GuidedGrid, a_line_follows_an_edge_and_the_picture_is_close) {
  constexpr double close_levels = 1.5;
  for (const EdgeCase& c : {EdgeCase{two_areas(), 50}, {two_areas(), 80}, {crease(), 24}}) {
    const TracedGrid with = traced(c.target, {edge(8, 110)}, c.points);
    const Followed line = followed(with.grid, 0);
    EXPECT_EQ(line.along, Along::rows);
    EXPECT_LT(line.farthest_point, 1e-6);
    EXPECT_LT(line.farthest_side, 1.2);
    EXPECT_NEAR(line.length, with.grid.guides()[0].length(), 1e-6);
    EXPECT_LE(with.grid.points(), c.points);
    EXPECT_FALSE(with.grid.folds());
    EXPECT_LT(std::sqrt(with.squares / (3 * c.target.counted())), close_levels);
  }
}

TEST(Guide, is_a_way_along_a_line) {
  const Guide guide({{0, 0}, {10, 0}, {10, 0}, {10, 20}});
  EXPECT_EQ(guide.length(), 30);
  EXPECT_EQ(guide.at(15), glm::dvec2(10, 5));
  EXPECT_EQ(guide.at(-1), glm::dvec2(0, 0));
  EXPECT_EQ(guide.direction(25), glm::dvec2(0, 1));
  EXPECT_EQ(guide.nearest({14, 12}), 22);
  EXPECT_EQ(guide.piece(25, 5), Guide({{10, 15}, {10, 0}, {5, 0}}));
  const auto ways = guide.crossing(Guide({{0, 8}, {20, 8}}), {0, 0});
  ASSERT_TRUE(ways);
  EXPECT_EQ(*ways, std::pair(18.0, 10.0));
  EXPECT_FALSE(guide.crossing(Guide({{0, 8}, {9, 8}}), {0, 0}));
}

TEST(GuidedGrid, ends_at_the_border_with_a_guide_beyond_it) {
  const TargetPicture target = two_areas();
  const TracedGrid found = traced(target, {edge(-30, 150)}, 50);
  const Followed line = followed(found.grid, 0);
  EXPECT_EQ(line.points, found.grid.columns() + 1);
  EXPECT_LT(line.farthest_point, 1e-6);
  EXPECT_EQ(found.grid.knot(line.line, 0).position.x, 0);
  EXPECT_EQ(found.grid.knot(line.line, found.grid.columns()).position.x, page.x);
  EXPECT_EQ(guided_grid(LineGrid(5, 5, page), {edge(130, 150)}, 100).unused,
            std::vector<std::size_t>{0});
}

TEST(GuidedGrid, guides_cross_where_a_point_is_held) {
  const TargetPicture target = two_areas();
  Line down;
  for (int y = 5; y < 85; ++y) down.emplace_back(50 + 0.003 * y * y, y);
  const TracedGrid found = traced(target, {edge(8, 110), down}, 70);
  const Followed row = followed(found.grid, 0), column = followed(found.grid, 1);
  ASSERT_EQ(row.along, Along::rows);
  ASSERT_EQ(column.along, Along::columns);
  EXPECT_LT(std::max(row.farthest_point, column.farthest_point), 1e-6);
  const LineGrid::Knot& knot = found.grid.knot(row.line, column.line);
  EXPECT_TRUE(knot.is_held());
  EXPECT_TRUE(knot.follows(Along::rows) && knot.follows(Along::columns));
  EXPECT_FALSE(found.grid.folds());
}

TEST(GuidedGrid, of_what_turns_back_the_longest_piece_is_followed) {
  Line ring;
  for (int k = 0; k <= 90; ++k) {
    const double a = k * std::numbers::pi / 45;
    ring.push_back({60 + 35 * std::cos(a), 45 + 25 * std::sin(a)});
  }
  const Line hook{{20, 30}, {90, 32}, {92, 40}, {50, 44}};
  for (const Line& line : {ring, hook}) {
    const GuidedGrid guided = guided_grid(LineGrid(5, 6, page), {line}, 100);
    EXPECT_TRUE(guided.unused.empty());
    EXPECT_FALSE(guided.grid.folds());
    EXPECT_LT(followed(guided.grid, 0).farthest_point, 1e-6);
    EXPECT_GT(followed(guided.grid, 0).length, 50);
  }
}

TEST(GuidedGrid, lines_that_guides_need_stay) {
  const TargetPicture target = two_areas();
  const TracedGrid found = traced(target, {edge(8, 110)}, 50);
  StopWatch watch(0, {});
  const std::vector<LineGrid> grids = thinned_grids(found.grid, target, watch);
  ASSERT_FALSE(grids.empty());
  for (const LineGrid& grid : grids) {
    EXPECT_LT(followed(grid, 0).farthest_point, 1e-6);
    EXPECT_NEAR(followed(grid, 0).length, grid.guides()[0].length(), 1e-6);
  }
  EXPECT_EQ(grids.back().rows(), 2);
  EXPECT_EQ(grids.back().columns(), 3);
}

TEST(GuidedGrid, guides_that_do_not_fit_are_left_out) {
  const LineGrid grid(5, 6, page);
  const GuidedGrid guided = guided_grid(
      grid, {{}, {{3, 3}}, {{3, 3}, {3, 3}}, edge(8, 110), {{20, 1}, {NAN, 40}}, edge(8, 110)},
      100);
  EXPECT_EQ(guided.unused, (std::vector<std::size_t>{0, 1, 2, 4, 5}));
  EXPECT_EQ(guided_grid(LineGrid(1, 1, page), {edge(8, 110)}, 4).unused,
            std::vector<std::size_t>{0});
  // One after the other until there is no more room.
  std::vector<Line> many;
  for (int k = 0; k < 40; ++k) many.push_back({{10.0 + k, 5}, {30.0 + 2 * k, 80.0 - k}});
  const GuidedGrid some = guided_grid(grid, many, 150);
  EXPECT_FALSE(some.unused.empty());
  EXPECT_LE(some.grid.points(), 150);
  EXPECT_FALSE(some.grid.folds());
  for (std::size_t n = 0; n < some.grid.guides().size(); ++n)
    EXPECT_LT(followed(some.grid, int(n)).farthest_point, 2);
}

TEST(GuidedGrid, strokes_of_one_edge_are_followed_by_one_line) {
  const Line before{{8, 40}, {50, 42}}, after{{60, 42}, {80, 41}, {110, 44}};
  const GuidedGrid guided = guided_grid(LineGrid(5, 6, page), {before, after}, 100);
  ASSERT_TRUE(guided.unused.empty());
  const Followed one = followed(guided.grid, 0), other = followed(guided.grid, 1);
  EXPECT_EQ(one.line, other.line);
  EXPECT_LT(std::max(one.farthest_point, other.farthest_point), 1e-6);
  EXPECT_FALSE(guided.grid.folds());
}

TEST(GuidedGrid, guides_meet_at_a_corner) {
  const Line across{{30, 40}, {90, 45}}, down{{30.5, 40.2}, {35, 80}};
  const GuidedGrid guided = guided_grid(LineGrid(5, 6, page), {across, down}, 100);
  ASSERT_TRUE(guided.unused.empty());
  EXPECT_EQ(followed(guided.grid, 1).along, Along::columns);
  EXPECT_LT(followed(guided.grid, 0).farthest_point, 1e-6);
  EXPECT_LT(followed(guided.grid, 1).farthest_point, 1);
  EXPECT_FALSE(guided.grid.folds());
}

TEST(GuidedGrid, does_not_fold_whatever_is_drawn) {
  const TargetPicture target = two_areas();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> x(-20, 140), y(-20, 110), step(-25, 25);
  for (int round = 0; round < 60; ++round) {
    std::vector<Line> lines(1 + std::size_t(round % 5));
    for (Line& line : lines) {
      line.push_back({x(random), y(random)});
      const glm::dvec2 mean(step(random), step(random));
      for (int k = 0; k < 6; ++k)
        line.push_back(line.back() + mean + 0.4 * glm::dvec2(step(random), step(random)));
    }
    LineGrid grid = guided_grid(LineGrid(1 + round % 7, 1 + round % 4, page), lines, 120).grid;
    ASSERT_FALSE(grid.folds()) << round;
    EXPECT_LE(grid.points(), 120);
    if (round % 6 == 0) fit_lines(grid, target, {}, {4, 1e-3});
    ASSERT_FALSE(grid.folds()) << round;
    for (int n = 0; n < grid.points(); ++n)
      for (const Along along : {Along::rows, Along::columns}) {
        const LineGrid::OnGuide& on = grid.knot(n).on_guide(along);
        if (on.guide < 0) continue;
        const glm::dvec2 place = grid.guides()[std::size_t(on.guide)].at(on.way);
        EXPECT_LT(glm::distance(grid.knot(n).position, place), grid.knot(n).is_held() ? 2 : 1e-6);
      }
  }
}

TEST(GuidedGrid, guides_cross_a_shape) {
  Line oval;
  for (int k = 0; k < 90; ++k) {
    const double a = k * std::numbers::pi / 45;
    oval.push_back({60 + 52 * std::cos(a), 45 + 38 * std::sin(a)});
  }
  const auto grid = outline_grid({oval}, 4, 5, page);
  ASSERT_TRUE(grid);
  for (const Line& line : {edge(25, 95), edge(-10, 130)}) {
    const GuidedGrid guided = guided_grid(*grid, {line}, 100);
    ASSERT_TRUE(guided.unused.empty());
    EXPECT_FALSE(guided.grid.folds());
    EXPECT_LT(followed(guided.grid, 0).farthest_point, 1e-6);
    EXPECT_GT(followed(guided.grid, 0).length, 60);
  }
}

TEST(GuidedGrid, is_the_grid_where_there_are_no_guides) {
  const LineGrid grid(5, 6, page);
  EXPECT_EQ(guided_grid(grid, {}, 100).grid, grid);
}

TEST(GuidedGrid, is_the_same_on_any_number_of_threads) {
  const TargetPicture target = two_areas();
  const LineGrid some = traced(target, {edge(8, 110)}, 40).grid;
  const ThreadLimit one(1);
  EXPECT_EQ(traced(target, {edge(8, 110)}, 40).grid, some);
}

}  // namespace
}  // namespace gradmesh
