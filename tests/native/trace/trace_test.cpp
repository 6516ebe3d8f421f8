#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "base/parallel.h"
#include "form/handles.h"
#include "mesh/build.h"
#include "trace/equations.h"
#include "trace/evenness.h"
#include "trace/line_changes.h"
#include "trace/line_fit.h"
#include "trace/pixels.h"
#include "trace/traced_grid.h"

namespace gradmesh {
namespace {

using Paint = std::function<glm::vec4(double, double)>;

/// A picture of what `paint` says of the places where a mesh has its colours.
TargetPicture painted(int width, int height, const Paint& paint, double point = 0.5) {
  TargetPicture target;
  target.width = width;
  target.height = height;
  target.point = point;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      target.pixels.push_back(paint(x + point, y + point));
      target.is_opaque = target.is_opaque && target.pixels.back().a == 255;
    }
  return target;
}

/// A grid whose points and colours were moved at random, by so little that nothing folds.
LineGrid random_grid(int rows, int columns, glm::dvec2 size, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(-0.2, 0.2), level(20, 235);
  LineGrid grid(rows, columns, size);
  for (int n = 0; n < grid.points(); ++n) {
    for (int way = 0; way < grid.knot(n).ways; ++way)
      grid.knot(n).position +=
          share(random) * size / glm::dvec2(columns, rows) * grid.knot(n).way[std::size_t(way)];
    for (int k = 0; k < 4; ++k) grid.knot(n).color[k] = level(random);
  }
  return grid;
}

/// The picture of a grid, without an edge of a pixel that is not its own.
TargetPicture picture_of(const LineGrid& grid, int width, int height, bool is_opaque = true) {
  TargetPicture target = painted(
      width, height, [](double, double) { return glm::vec4(0, 0, 0, 255); }, 0.74);
  const glm::dvec2 scale = pixels_per_unit(grid, target);
  for (int i = 0; i < grid.rows(); ++i)
    for (int j = 0; j < grid.columns(); ++j) {
      const std::array<int, 4> at = grid.corners(i, j);
      Quad quad;
      for (std::size_t k = 0; k < 4; ++k) quad[k] = scale * grid.knot(at[k]).position;
      const QuadMap map(quad);
      for_each_pixel(quad, width, height, target.point, [&](int x, int y) {
        const glm::dvec2 p = map.parameters(glm::dvec2(x, y) + target.point);
        const glm::dvec4 top = glm::mix(grid.knot(at[0]).color, grid.knot(at[1]).color, p.y);
        const glm::dvec4 bottom = glm::mix(grid.knot(at[3]).color, grid.knot(at[2]).color, p.y);
        glm::vec4& pixel = target.pixels[std::size_t(y * width + x)];
        pixel = glm::vec4(glm::mix(top, bottom, p.x));
        if (is_opaque) pixel.a = 255;
      });
    }
  target.is_opaque = is_opaque;
  return target;
}

double rmse(const LineGrid& grid, const TargetPicture& target) {
  return std::sqrt(squares_of(grid, target) / (3.0 * double(target.samples())));
}

using IsEnough = std::function<bool(const LineGrid&)>;

LineGrid traced(const TargetPicture& target, int points, StopWatch& watch,
                const IsEnough& is_enough = {},
                const std::function<void(const LineGrid&)>& tell = {}) {
  std::vector<Beginning> beginnings;
  for (const LineGrid& grid : even_grids(target, {target.width, target.height}, points))
    beginnings.push_back({&target, grid, is_enough});
  return traced_grid(beginnings, points, watch, tell).grid;
}

LineGrid traced(const TargetPicture& target, int points, const IsEnough& is_enough = {}) {
  StopWatch watch(0, {});
  return traced(target, points, watch, is_enough);
}

TEST(LineGrid, looks_the_same_with_one_line_more) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const LineGrid grid = random_grid(3, 4, {50, 40}, seed);
    const TargetPicture picture = picture_of(grid, 100, 80, false);
    for (const Along along : {Along::rows, Along::columns})
      for (int strip = 0; strip < 3; ++strip) {
        const LineGrid finer = grid.with_line(along, strip);
        EXPECT_EQ(finer.rows() + finer.columns(), 8);
        EXPECT_NEAR(squares_of(finer, picture), 0, 1e-4);
        EXPECT_EQ(finer.size(), grid.size());
      }
  }
}

TEST(LineGrid, is_a_mesh_that_costs_a_handle_a_point) {
  const LineGrid grid = random_grid(3, 5, {60, 40}, 7);
  const Mesh mesh = build_mesh(grid.parts());
  EXPECT_EQ(mesh.face_count(), 15);
  EXPECT_EQ(count_handles(mesh), grid.points());
}

TEST(Pixels, belong_to_one_patch_each) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const LineGrid grid = random_grid(4, 5, {37, 29}, seed);
    std::vector<int> visits(37 * 29, 0);
    for (int i = 0; i < grid.rows(); ++i)
      for (int j = 0; j < grid.columns(); ++j) {
        Quad quad;
        for (std::size_t k = 0; k < 4; ++k) quad[k] = grid.knot(grid.corners(i, j)[k]).position;
        const QuadMap map(quad);
        for_each_pixel(quad, 37, 29, 0.5, [&](int x, int y) {
          const glm::dvec2 at = map.parameters(glm::dvec2(x, y) + 0.5);
          ++visits[std::size_t(y * 37 + x)];
          const glm::dvec2 back =
              glm::mix(glm::mix(quad[0], quad[1], at.y), glm::mix(quad[3], quad[2], at.y), at.x);
          EXPECT_NEAR(back.x, x + 0.5, 1e-6);
          EXPECT_NEAR(back.y, y + 0.5, 1e-6);
        });
      }
    EXPECT_EQ(visits, std::vector<int>(37 * 29, 1));
  }
}

/// The equations' right-hand side is minus half of the gradient of the squares.
TEST(Equations, know_how_the_squares_change) {
  for (const bool is_opaque : {true, false}) {
    const LineGrid grid = random_grid(2, 2, {64, 64}, 3);
    const TargetPicture target = picture_of(random_grid(3, 3, {64, 64}, 5), 64, 64, is_opaque);
    const GridColumns columns(grid, target);
    Eigen::VectorXd rhs = Eigen::VectorXd::Zero(columns.count());
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) {
        const NormalEquations part = patch_equations(grid, i, j, target, columns);
        EXPECT_NEAR(part.squares, patch_squares(grid, i, j, target), 1e-6 * part.squares);
        for (std::size_t a = 0; a < part.columns.size(); ++a)
          rhs(part.columns[a]) += part.rhs(Eigen::Index(a));
      }
    const auto slope = [&](const auto& change, double by) {
      LineGrid more = grid, less = grid;
      change(more, by);
      change(less, -by);
      return (squares_of(more, target) - squares_of(less, target)) / (2 * by);
    };
    const int middle = grid.number(1, 1);
    for (int k = 0; k < channels(target); ++k)
      EXPECT_NEAR(slope([&](LineGrid& g, double by) { g.knot(middle).color[k] += by; }, 0.01),
                  -2 * rhs(columns.of(middle).color + k), 1);
    // A pixel that passes from one patch to another makes the squares a little uneven.
    const double scale =
        std::abs(rhs(columns.of(middle).place[0])) + std::abs(rhs(columns.of(middle).place[1]));
    for (const int axis : {0, 1})
      EXPECT_NEAR(slope([&](LineGrid& g, double by) { g.knot(middle).position[axis] += by; }, 0.05),
                  -2 * rhs(columns.of(middle).place[std::size_t(axis)]), 0.05 * scale);
  }
}

TEST(Evenness, is_nothing_in_an_even_grid_and_pulls_others_even) {
  const TargetPicture target = painted(60, 40, [](double, double) { return glm::vec4(255); });
  const Evenness by;
  EXPECT_NEAR(unevenness(LineGrid(3, 4, {60, 40}), target, by), 0, 1e-12);
  LineGrid grid = random_grid(3, 4, {60, 40}, 2);
  const double before = unevenness(grid, target, by);
  fit_lines(grid, target, by, {40, 1e-6});
  EXPECT_LT(unevenness(grid, target, by), 0.05 * before);
}

TEST(LineFit, finds_the_grid_that_a_picture_was_painted_of) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const TargetPicture target = picture_of(random_grid(3, 3, {90, 90}, seed), 90, 90);
    LineGrid grid(3, 3, {90, 90});
    fit_colors(grid, target);
    const double before = rmse(grid, target);
    fit_lines(grid, target, Evenness().times(1e-3), {60, 1e-5});
    EXPECT_LT(rmse(grid, target), 0.1 * before);
    EXPECT_FALSE(grid.folds());
  }
}

TEST(LineChanges, put_a_line_in_where_the_picture_bends) {
  // Flat, but for a ridge in the lower part.
  const TargetPicture target = painted(80, 80, [](double, double y) {
    const float level = float(255 - 6 * std::min(30.0, std::abs(y - 60)));
    return glm::vec4(level, level, level, 255);
  });
  LineGrid grid(2, 2, {80, 80});
  fit_colors(grid, target);
  const auto line = best_new_line(grid, target, {8, 8, 100}, 0);
  ASSERT_TRUE(line);
  EXPECT_EQ(line->along, Along::rows);
  EXPECT_EQ(line->number, 1);
  EXPECT_GT(line->squares, 0);
  EXPECT_FALSE(best_new_line(grid, target, {2, 2, 100}, 0));
  EXPECT_FALSE(best_new_line(grid, target, {8, 8, 11}, 0));
}

TEST(LineChanges, take_out_the_line_that_is_needed_least) {
  LineGrid grid = random_grid(3, 3, {90, 90}, 8);
  const TargetPicture target = picture_of(grid, 90, 90);
  const LineGrid finer = grid.with_line(Along::columns, 1);
  const auto line = cheapest_line(finer, target, 0);
  ASSERT_TRUE(line);
  EXPECT_EQ(line->along, Along::columns);
  EXPECT_EQ(line->number, 2);
  EXPECT_NEAR(line->squares, 0, 1);
  EXPECT_EQ(finer.without_line(line->along, line->number), grid);
  EXPECT_FALSE(cheapest_line(LineGrid(1, 1, {90, 90}), target, 0));
}

TEST(TracedGrid, follows_an_edge_with_few_lines) {
  const TargetPicture target = painted(120, 100, [](double x, double y) {
    const float level = x + 0.3 * y > 80 ? 230.0f : 40.0f;
    return glm::vec4(level, level / 2, 255 - level, 255);
  });
  const LineGrid grid = traced(target, 60);
  EXPECT_LE(grid.points(), 60);
  EXPECT_FALSE(grid.folds());
  LineGrid even(5, 9, {120, 100});
  fit_colors(even, target);
  EXPECT_LT(rmse(grid, target), 0.3 * rmse(even, target));
}

TEST(TracedGrid, needs_four_points_for_what_is_flat) {
  const TargetPicture target =
      painted(40, 30, [](double, double) { return glm::vec4(10, 200, 30, 255); });
  const LineGrid grid = traced(target, 200);
  EXPECT_EQ(grid.points(), 4);
  EXPECT_NEAR(rmse(grid, target), 0, 1e-6);
  EXPECT_EQ(grid.knot(0).color, glm::dvec4(10, 200, 30, 255));
}

TEST(TracedGrid, keeps_opacities) {
  const TargetPicture target = painted(80, 80, [](double x, double y) {
    const double away = std::hypot(x - 40, y - 40);
    return glm::vec4(200, 80, 20, std::clamp(255 - 10 * (away - 20), 0.0, 255.0));
  });
  ASSERT_FALSE(target.is_opaque);
  const LineGrid grid = traced(target, 144);
  EXPECT_LT(rmse(grid, target), 12);
  EXPECT_LT(grid.knot(0).color.a, 20);
  EXPECT_FALSE(grid.folds());
}

TEST(TracedGrid, is_made_of_the_smallest_and_narrowest_pictures) {
  const Paint checks = [](double x, double y) {
    return (int(x) + int(y)) % 2 ? glm::vec4(255) : glm::vec4(0, 0, 0, 255);
  };
  for (const auto& [width, height] : {std::pair(1, 1), {1, 90}, {90, 1}, {8, 8}, {3, 200}}) {
    const LineGrid grid = traced(painted(width, height, checks), 100);
    EXPECT_FALSE(grid.folds()) << width << " x " << height;
    EXPECT_LE(grid.points(), 100);
  }
}

TEST(TracedGrid, of_noise_neither_folds_nor_fails) {
  std::mt19937 random(11);
  std::uniform_int_distribution<int> level(0, 255);
  const TargetPicture target = painted(64, 64, [&](double, double) {
    return glm::vec4(level(random), level(random), level(random), 255);
  });
  EXPECT_FALSE(traced(target, 120).folds());
}

TEST(TracedGrid, ends_when_it_is_enough_or_told_to_stop) {
  const TargetPicture target = picture_of(random_grid(6, 6, {100, 100}, 4), 100, 100);
  const LineGrid enough = traced(target, 400, [](const LineGrid& g) { return g.points() >= 40; });
  EXPECT_LT(enough.points(), 60);
  int told = 0, times_after = 0;
  StopWatch watch(0, [&](const Progress& progress) {
    told = progress.handles;
    times_after += progress.done >= 30;
    return progress.done < 30;
  });
  const LineGrid stopped = traced(target, 400, watch);
  EXPECT_EQ(times_after, 1);
  EXPECT_GE(stopped.points(), 30);
  EXPECT_EQ(stopped.points(), told);
  EXPECT_FALSE(stopped.folds());
}

TEST(TracedGrid, comes_closer_to_the_end_through_all_beginnings) {
  const TargetPicture target = picture_of(random_grid(6, 6, {100, 100}, 4), 100, 100);
  std::vector<std::size_t> done;
  std::size_t total = 0;
  StopWatch watch(0, [&](const Progress& progress) {
    done.push_back(progress.done);
    total = progress.total;
    return true;
  });
  traced(target, 60, watch);
  EXPECT_TRUE(std::ranges::is_sorted(done));
  EXPECT_LE(done.back(), total);
  EXPECT_GT(double(done.back()), 0.85 * double(total));
}

TEST(TracedGrid, is_whole_wherever_it_is_stopped) {
  const TargetPicture target = picture_of(random_grid(9, 9, {100, 100}, 4), 100, 100);
  for (const std::size_t most : {1, 55, 120, 185, 220, 1000}) {
    StopWatch watch(0, [&](const Progress& progress) { return progress.done < most; });
    const LineGrid grid = traced(target, 60, watch);
    EXPECT_LE(grid.points(), 60);
    EXPECT_FALSE(grid.folds());
  }
}

TEST(TracedGrid, tells_of_the_best_so_far_alone) {
  // One thread works on the beginnings in order: of several, a later one may have grown first.
  const ThreadLimit one(1);
  const TargetPicture target = picture_of(random_grid(9, 9, {100, 100}, 4), 100, 100);
  std::vector<double> left;
  std::vector<Progress> told;
  StopWatch watch(0, [&](const Progress& progress) {
    told.push_back(progress);
    return true;
  });
  const LineGrid grid = traced(target, 60, watch, {},
                               [&](const LineGrid& best) { left.push_back(rmse(best, target)); });
  ASSERT_EQ(left.size(), told.size());
  for (std::size_t n = 1; n < left.size(); ++n) {
    // What grows is fitted to a smaller picture.
    const bool is_grown = told[n - 1].done > 60;
    EXPECT_LE(left[n], (is_grown ? 1.001 : 1.05) * left[n - 1]) << n;
  }
  EXPECT_EQ(told.back().handles, grid.points());
}

TEST(TracedGrid, tells_of_what_a_stop_would_keep) {
  const TargetPicture target = picture_of(random_grid(6, 6, {100, 100}, 4), 100, 100);
  const IsEnough is_enough = [&](const LineGrid& grid) { return rmse(grid, target) < 4; };
  bool is_whole = false;
  for (std::size_t asked = 1; !is_whole; asked += 3) {
    std::size_t times = 0;
    int told = 0;
    StopWatch watch(0, [&](const Progress& progress) {
      told = progress.handles;
      return ++times < asked;
    });
    EXPECT_EQ(traced(target, 60, watch, is_enough).points(), told) << asked;
    is_whole = times < asked;
  }
}

TEST(TracedGrid, is_the_same_on_any_number_of_threads) {
  const TargetPicture target = picture_of(random_grid(7, 7, {90, 70}, 6), 90, 70);
  const LineGrid some = traced(target, 80);
  const ThreadLimit one(1);
  EXPECT_EQ(traced(target, 80), some);
}

}  // namespace
}  // namespace gradmesh
