#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/parallel.h"
#include "form/handles.h"
#include "mesh/build.h"
#include "mesh/rectangle.h"
#include "meshes.h"
#include "methods/plain/flaws.h"
#include "methods/plain/grid_fit.h"
#include "methods/plain/rises.h"
#include "problems.h"
#include "raster/folds.h"
#include "simplify/simplify.h"
#include "trial/edit_error.h"

namespace gradmesh {
namespace {

using test::grid_mesh;

Mesh noisy_grid(int rows, int columns, unsigned seed) {
  return grid_mesh({.rows = rows, .columns = columns, .position_noise = 0.05, .color_noise = 0.04},
                   seed);
}

RunOptions plain_options(double epsilon) {
  RunOptions options;
  options.method = plain_method;
  options.epsilon = epsilon;
  options.resolution = 150;
  return options;
}

TEST(PlainGrid, holds_a_grid_of_Coons_patches_as_it_is) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    MeshParts parts = PlainGrid(noisy_grid(3, 4, seed)).parts();
    ASSERT_EQ(parts.patches.size(), 12u);
    const MeshParts again = PlainGrid(build_mesh(parts)).parts();
    for (std::size_t k = 0; k < parts.patches.size(); ++k)
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
          const Value &a = parts.patches[k].c[i][j], &b = again.patches[k].c[i][j];
          EXPECT_NEAR(a.position.x, b.position.x, 1e-9);
          EXPECT_NEAR(a.position.y, b.position.y, 1e-9);
          EXPECT_EQ(a.color, b.color);
        }
  }
}

TEST(PlainGrid, counts_what_the_mesh_tool_shows) {
  PlainGrid grid(noisy_grid(3, 4, 1));
  // 20 points, and 31 sides of which every one is a curve.
  EXPECT_EQ(grid.handles(), 20 + 2 * 31);
  grid.bend(Along::rows, 1, 2).reset();
  EXPECT_EQ(grid.handles(), 20 + 2 * 30);
  EXPECT_EQ(count_handles(build_mesh(grid.parts())), grid.handles());
}

TEST(PlainGrid, loses_a_line_and_no_other_point) {
  const PlainGrid before(noisy_grid(3, 4, 2));
  for (const Along along : {Along::rows, Along::columns}) {
    PlainGrid after = before;
    after.take_out(along, 2);
    const bool is_row = along == Along::rows;
    EXPECT_EQ(after.rows(), is_row ? 2 : 3);
    EXPECT_EQ(after.columns(), is_row ? 4 : 3);
    for (int i = 0; i <= after.rows(); ++i)
      for (int j = 0; j <= after.columns(); ++j)
        EXPECT_EQ(after.knot(i, j), before.knot(i + (is_row && i >= 2), j + (!is_row && j >= 2)));
    EXPECT_EQ(find_grid(build_mesh(after.parts()))->tops.size(),
              std::size_t(after.rows() * after.columns()));
  }
}

TEST(Handles, of_a_patch_that_is_no_Coons_patch_are_four_more) {
  MeshParts parts = PlainGrid(noisy_grid(1, 1, 1)).parts();
  EXPECT_EQ(count_handles(build_mesh(parts)), 4 + 8);
  parts.patches[0].c[1][1].position += glm::dvec2(30, 10);
  EXPECT_EQ(count_handles(build_mesh(parts)), 4 + 8 + 4);
}

TEST(GridFit, brings_points_back_that_were_moved) {
  const Mesh mesh = noisy_grid(4, 4, 3);
  const Reference target(mesh, fit_frame(mesh, {}, 200), MetricKind::flip);
  const PlainGrid original(mesh);
  PlainGrid moved = original;
  moved.knot(2, 2).position += glm::dvec2(9, -7);
  PlainGrid fitted = moved;
  const double once = fit_grid(fitted, target, 1), more = fit_grid(fitted, target, 8);
  EXPECT_LE(more, once);
  const auto off = [&](const PlainGrid& grid) {
    return glm::length(grid.knot(2, 2).position - original.knot(2, 2).position);
  };
  EXPECT_LT(off(fitted), 0.3 * off(moved));
}

double all_squares(const PlainGrid& grid, const Reference& target) {
  const PaintedGrid painted(grid);
  double squares = 0;
  for (int i = 0; i < grid.rows(); ++i)
    for (int j = 0; j < grid.columns(); ++j) squares += patch_squares(painted, i, j, target);
  return squares;
}

TEST(LineRises, tell_what_fits_find) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Mesh mesh = noisy_grid(6, 5, seed);
    const Reference target(mesh, fit_frame(mesh, {}, 200), MetricKind::flip);
    const PlainGrid grid(mesh);
    std::vector<Step> lines;
    for (int i = 1; i < 6; ++i) lines.push_back({{}, Along::rows, i});
    for (int i = 1; i < 5; ++i) lines.push_back({{}, Along::columns, i});
    const std::vector<LineRise> expected = rises_without(grid, lines, target);
    std::vector<double> found;
    for (std::size_t n = 0; n < lines.size(); ++n) {
      PlainGrid without = grid;
      make(lines[n], without);
      EXPECT_EQ(expected[n].saved, grid.handles() - without.handles());
      fit_grid(without, target, 4, points_near(lines[n], without));
      found.push_back(std::sqrt(all_squares(without, target) - all_squares(grid, target)));
      EXPECT_GT(expected[n].root, 0.5 * found[n]) << n;
      EXPECT_LT(expected[n].root, 1.5 * found[n]) << n;
    }
    const auto cheapest = std::ranges::min_element(expected, {}, &LineRise::root);
    EXPECT_LT(found[std::size_t(cheapest - expected.begin())], 1.2 * std::ranges::min(found));
  }
}

TEST(GridFit, leaves_straight_sides_straight_and_colours_alone_and_folds_nothing) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Mesh mesh = noisy_grid(4, 5, seed);
    const Reference target(mesh, fit_frame(mesh, {}, 150), MetricKind::flip);
    PlainGrid grid(mesh);
    for (int j = 0; j < 5; ++j) grid.bend(Along::rows, 2, j).reset();
    const PlainGrid before = grid;
    fit_grid(grid, target, 4);
    EXPECT_EQ(grid.handles(), before.handles());
    for (int i = 0; i <= 4; ++i)
      for (int j = 0; j <= 5; ++j) EXPECT_EQ(grid.knot(i, j).color, before.knot(i, j).color);
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 5; ++j)
        EXPECT_TRUE(!may_fold(grid.patch(i, j)) || may_fold(before.patch(i, j)));
  }
}

TEST(GridFit, moves_only_the_points_it_is_given) {
  const Mesh mesh = noisy_grid(6, 6, 4);
  const Reference target(mesh, fit_frame(mesh, {}, 200), MetricKind::flip);
  PlainGrid grid(mesh);
  for (int i = 1; i < 6; ++i)
    for (int j = 1; j < 6; ++j) grid.knot(i, j).position += glm::dvec2(3, -2);
  const PlainGrid before = grid;
  GridPoints points(grid);
  points.add({1, 2, 0, 3});
  fit_grid_and_colors(grid, target, 3, points);
  bool any = false;
  for (int i = 0; i <= 6; ++i)
    for (int j = 0; j <= 6; ++j) {
      const bool has_moved = grid.knot(i, j) != before.knot(i, j);
      any |= has_moved;
      EXPECT_TRUE(!has_moved || points.contains(i, j)) << i << " " << j;
    }
  EXPECT_TRUE(any);
}

TEST(GridFit, brings_colours_back_in_whole_levels_and_leaves_the_others) {
  // Colours as a document has them.
  PlainGrid original(noisy_grid(4, 4, 7));
  const auto whole = [](const glm::dvec4& color) { return glm::round(color * 255.0) / 255.0; };
  for (int i = 0; i <= 4; ++i)
    for (int j = 0; j <= 4; ++j) original.knot(i, j).color = whole(original.knot(i, j).color);
  const Mesh mesh = build_mesh(original.parts());
  const Reference target(mesh, fit_frame(mesh, {}, 300), MetricKind::flip);
  PlainGrid grid = original;
  glm::dvec4& changed = grid.knot(2, 1).color;
  for (int k = 0; k < 3; ++k) changed[k] += (changed[k] > 0.5 ? -30 : 30) / 255.0;
  fit_grid_and_colors(grid, target, 4, GridPoints::all(grid));
  for (int i = 0; i <= 4; ++i)
    for (int j = 0; j <= 4; ++j) {
      const glm::dvec4 now = grid.knot(i, j).color, was = original.knot(i, j).color;
      EXPECT_LT(glm::length(now - whole(now)), 1e-12);
      EXPECT_LT(glm::length(now - was), i == 2 && j == 1 ? 3 / 255.0 : 1e-12) << i << " " << j;
    }
}

TEST(GridFit, leaves_the_colours_of_translucent_points_alone) {
  const Mesh mesh = noisy_grid(4, 4, 7);
  const Reference target(mesh, fit_frame(mesh, {}, 200), MetricKind::flip);
  for (const double alpha : {1.0, 0.5}) {
    PlainGrid grid(mesh);
    grid.knot(2, 2).color = {0.1, 0.9, 0.3, alpha};
    const glm::dvec4 before = grid.knot(2, 2).color;
    fit_grid_and_colors(grid, target, 2, GridPoints::all(grid));
    EXPECT_EQ(grid.knot(2, 2).color == before, alpha < 1);
  }
}

TEST(BorderGap, is_how_far_the_border_is_from_where_it_was) {
  const Mesh mesh = noisy_grid(4, 4, 2);
  const Reference picture(mesh, fit_frame(mesh, {}, 200), MetricKind::flip);
  PlainGrid grid(mesh);
  EXPECT_LT(border_gap(grid, picture), 0.6);
  const glm::dvec2 in = grid.knot(1, 2).position - grid.knot(0, 2).position;
  const double pixels = glm::length(picture.frame().to_pixels.vector(in));
  grid.knot(0, 2).position += 4 / pixels * in;
  EXPECT_NEAR(border_gap(grid, picture), 4, 1);
  grid.knot(0, 2).position += 0.8 * in;
  EXPECT_GT(border_gap(grid, picture), 8);
}

/// A grid of 3 x 3 squares one point of which is moved down to `y`, mirrored or not.
PlainGrid grid_with_point_at(double y, bool is_mirrored) {
  PlainGrid grid(grid_mesh({.rows = 3, .columns = 3}));
  grid.knot(1, 1).position.y = y;
  for (int i = 0; i <= 3; ++i)
    for (int j = 0; j <= 3; ++j)
      if (is_mirrored) grid.knot(i, j).position.x *= -1;
  return grid;
}

TEST(Crush, is_where_lines_nearly_touch_or_cross) {
  for (const bool is_mirrored : {false, true}) {
    const auto share = [&](double y) {
      return narrowest_share(grid_with_point_at(y, is_mirrored).patch(1, 1));
    };
    EXPECT_NEAR(share(100), 1, 1e-12);
    EXPECT_GT(share(180), 0.1);
    EXPECT_GT(share(199.5), 0);
    EXPECT_LT(share(199.5), 0.1);
    EXPECT_LT(share(215), 0);
    const Crush crush(grid_with_point_at(100, is_mirrored));
    EXPECT_FALSE(crush.is_worse(grid_with_point_at(180, is_mirrored)));
    EXPECT_TRUE(crush.is_worse(grid_with_point_at(199.5, is_mirrored)));
    const Crush narrow(grid_with_point_at(199, is_mirrored));
    EXPECT_FALSE(narrow.is_worse(grid_with_point_at(199.5, is_mirrored)));
    EXPECT_TRUE(narrow.is_worse(grid_with_point_at(215, is_mirrored)));
  }
}

TEST(Crush, does_not_grow_by_simplifying) {
  const RunOptions options = plain_options(0.1);
  for (unsigned seed = 1; seed <= 12; ++seed) {
    Mesh mesh =
        grid_mesh({.rows = 7, .columns = 6, .position_noise = 0.2, .color_noise = 0.1}, seed);
    const Crush crush{PlainGrid(mesh)};
    ASSERT_TRUE(simplify(mesh, options).changed);
    EXPECT_FALSE(crush.is_worse(PlainGrid(mesh))) << seed;
  }
}

/// A grid of 4 x 4 patches whose middle row of points lies on a smooth wave.
PlainGrid waved_grid() {
  PlainGrid grid(grid_mesh({.rows = 4, .columns = 4, .color_noise = 0.1}, 5));
  for (int j = 0; j < 4; ++j) {
    const auto along = [](int at) { return glm::dvec2(100, at % 2 == 0 ? 40 : -40); };
    grid.bend(Along::rows, 2, j) = {along(j), along(j + 1)};
  }
  return PlainGrid(build_mesh(grid.parts()));
}

TEST(GridFit, keeps_a_line_smooth_where_it_was_and_one_side_is_a_curve) {
  const PlainGrid original = waved_grid();
  const Mesh mesh = build_mesh(original.parts());
  const Reference target(mesh, fit_frame(mesh, {}, 200), MetricKind::flip);
  for (int j = 1; j < 4; ++j) ASSERT_TRUE(original.is_smooth(Along::rows, 2, j));
  EXPECT_FALSE(original.is_smooth(Along::columns, 2, 2)) << "a straight line was no curve";
  for (const bool has_straight_side : {false, true}) {
    PlainGrid grid = original;
    for (int j = 1; j < 4; ++j) grid.knot(2, j).position += glm::dvec2(6, 9 - 5 * j);
    if (has_straight_side) grid.bend(Along::rows, 2, 1).reset();
    fit_grid(grid, target, 4);
    EXPECT_NE(grid.knot(2, 2), original.knot(2, 2));
    for (int j = 1; j < 4; ++j) EXPECT_NEAR(grid.turn(Along::rows, 2, j), 0, 1e-6);
  }
}

TEST(Plain, keeps_a_smooth_mesh_smooth_with_fewer_handles) {
  MeshParts parts = PlainGrid(noisy_grid(6, 6, 3)).parts();
  parts.smooth = true;
  Mesh mesh = build_mesh(parts);
  const int before = count_handles(mesh);
  const SimplifyResult result = simplify(mesh, plain_options(0.02));
  EXPECT_TRUE(result.changed);
  EXPECT_LE(result.error, 0.02);
  EXPECT_TRUE(mesh.is_smooth());
  EXPECT_LT(count_handles(mesh), before / 2);
}

TEST(Plain, reaches_a_target_in_handles) {
  for (const int most : {60, 30, 4}) {
    Mesh mesh = noisy_grid(5, 5, 6);
    RunOptions options = plain_options(0.01);
    options.handles = most;
    const SimplifyResult result = simplify(mesh, options);
    EXPECT_LE(count_handles(mesh), most);
    EXPECT_GT(count_handles(mesh), most / 2 - 1);
    EXPECT_EQ(result.handles_after, count_handles(mesh));
  }
}

TEST(Plain, leaves_fewer_handles_and_keeps_to_epsilon_and_the_local_bound) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const Mesh original = noisy_grid(4, 5, seed);
    for (const double epsilon : {0.003, 0.02}) {
      Mesh mesh = original;
      RunOptions options = plain_options(epsilon);
      options.max_local_error = 0.08;
      const SimplifyResult result = simplify(mesh, options);
      EXPECT_EQ(result.handles_before, count_handles(original));
      EXPECT_EQ(result.handles_after, count_handles(mesh));
      EXPECT_TRUE(find_grid(mesh));
      if (!result.changed) {
        EXPECT_EQ(mesh, original);
        continue;
      }
      EXPECT_LT(result.handles_after, result.handles_before);
      EXPECT_LE(result.error, epsilon);
      const EditError error =
          test::edit_error(original, original, result.frame, options.metric, false, 0.08);
      const FrameError found = error.whole_frame(mesh);
      EXPECT_NEAR(found.mean, result.error, 1e-12);
      EXPECT_TRUE(found.keeps_to(epsilon));
    }
  }
}

TEST(Plain, is_the_same_for_any_number_of_threads) {
  const Mesh original = noisy_grid(4, 4, 7);
  std::optional<Mesh> first;
  for (const int threads : {1, 2, 3}) {
    Mesh mesh = original;
    RunOptions options = plain_options(0.02);
    options.threads = threads;
    simplify(mesh, options);
    if (!first) first = mesh;
    EXPECT_EQ(mesh, *first);
  }
  EXPECT_NE(*first, original);
}

TEST(Plain, refuses_what_no_plain_mesh_gradient_can_hold) {
  Mesh bicubic = grid_mesh({.rows = 2, .columns = 2, .color_model = ColorModel::bicubic});
  EXPECT_THROW(simplify(bicubic, plain_options(0.01)), InputError);
}

TEST(Plain, keeps_what_it_has_when_it_is_stopped) {
  const Mesh original = noisy_grid(5, 5, 4);
  Mesh mesh = original;
  RunOptions options = plain_options(0.05);
  int calls = 0;
  options.progress = [&](const Progress&) { return ++calls < 4; };
  const SimplifyResult result = simplify(mesh, options);
  EXPECT_EQ(result.stopped, Stopped::cancelled);
  EXPECT_EQ(result.handles_after, count_handles(mesh));
  EXPECT_LE(result.error, 0.05);
}

}  // namespace
}  // namespace gradmesh
