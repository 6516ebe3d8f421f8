#include "form/smooth_colors.h"

#include <gtest/gtest.h>

#include <functional>

#include "base/error.h"
#include "mesh/rectangle.h"
#include "mesh/validate.h"
#include "meshes.h"
#include "problems.h"
#include "raster/rasterizer.h"
#include "simplify/simplify.h"

namespace gradmesh {
namespace {

struct Shade {
  double red, alpha = 1;
};

/// A smooth mesh of straight patches between vertical lines at the places `x` and horizontal ones
/// at `y`, with reds and opacities `shade(i, j)` at the corners.
MeshParts lattice(const std::vector<double>& x, const std::vector<double>& y,
                  const std::function<Shade(int, int)>& shade) {
  const auto corner = [&](int i, int j) {
    const Shade s = shade(i, j);
    return Value{{x[j], y[i]}, {s.red, 0.25, 0.5, s.alpha}};
  };
  MeshParts parts;
  const int rows = int(y.size()) - 1, columns = int(x.size()) - 1;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j)
      parts.patches.push_back(test::straight_patch(
          {corner(i, j), corner(i, j + 1), corner(i + 1, j + 1), corner(i + 1, j)}));
  parts.curves = grid_curves(rows, columns);
  parts.smooth = true;
  return parts;
}

/// Red's derivatives along v at both ends of the patches of a single row, patch after patch.
std::vector<double> tangents(const std::vector<double>& x, const std::vector<double>& reds) {
  const Mesh mesh = build_mesh(lattice(x, {0, 10}, [&](int, int j) { return Shade{reds[j]}; }));
  std::vector<double> result;
  for (const Patch& patch : with_smooth_colors(mesh).patches) {
    result.push_back(patch.c[0][1].color.r);
    result.push_back(patch.c[0][2].color.r);
    EXPECT_EQ(patch.c[3][1], patch.c[0][1]);
  }
  return result;
}

void expect_near(const std::vector<double>& found, const std::vector<double>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-12) << i;
}

TEST(SmoothColors, take_their_slopes_from_both_neighbours) {
  // Inside 0.5 (0.1 / 1 + 0.3 / 2) = 0.125; at the ends 2 * 0.1 - 0.125 and 2 * 0.15 - 0.125. A
  // tangent is the slope times the length of its patch.
  expect_near(tangents({0, 1, 3}, {0.2, 0.3, 0.6}), {0.075, 0.125, 0.25, 0.35});
}

TEST(SmoothColors, are_level_at_a_local_extremum) {
  expect_near(tangents({0, 1, 2}, {0.2, 0.6, 0.5}), {0.8, 0, 0, -0.2});
  expect_near(tangents({0, 1, 2}, {0.6, 0.2, 0.5}), {-0.8, 0, 0, 0.6});
  // Where it is level on one side the limit makes it so.
  expect_near(tangents({0, 1, 2}, {0.2, 0.2, 0.5}), {0, 0, 0, 0.6});
}

TEST(SmoothColors, are_no_steeper_than_three_times_either_side) {
  // 0.5 (0.05 + 0.7) is more than 3 * 0.05; likewise falling, and with the steep side first.
  expect_near(tangents({0, 1, 2}, {0.1, 0.15, 0.85}), {-0.05, 0.15, 0.15, 1.25});
  expect_near(tangents({0, 1, 2}, {0.85, 0.15, 0.1}), {-1.25, -0.15, -0.15, 0.05});
}

TEST(SmoothColors, know_one_neighbour_only_along_a_single_patch) {
  // The first end takes 0 for the slope at the last, and that takes the first's: 2 d and 0.
  expect_near(tangents({0, 4}, {0.1, 0.4}), {0.6, 0});
}

TEST(SmoothColors, are_level_where_there_is_no_distance) {
  expect_near(tangents({0, 1, 1, 3}, {0.1, 0.3, 0.5, 0.6}), {0.4, 0, 0, 0, 0, 0.2});
}

TEST(SmoothColors, run_down_the_columns_as_along_the_rows) {
  const auto shade = [](int i, int j) { return Shade{0.1 + 0.2 * i * i + 0.05 * j}; };
  const Mesh mesh = build_mesh(lattice({0, 1, 2}, {0, 1, 3}, shade));
  const auto patches = with_smooth_colors(mesh).patches;
  // Slopes down: inside 0.5 (0.2 + 0.3), above 2 * 0.2 - 0.25, below 2 * 0.3 - 0.25.
  for (int j : {0, 1}) {
    EXPECT_NEAR(patches[j].c[1][0].color.r, 0.15, 1e-12);
    EXPECT_NEAR(patches[j].c[2][3].color.r, 0.25, 1e-12);
    EXPECT_NEAR(patches[2 + j].c[1][3].color.r, 0.5, 1e-12);
    EXPECT_NEAR(patches[2 + j].c[2][0].color.r, 0.7, 1e-12);
    EXPECT_NEAR(patches[j].c[0][1].color.r, 0.05, 1e-12);
  }
  for (const Patch& patch : patches)
    for (int i : {1, 2})
      for (int j : {1, 2}) EXPECT_EQ(glm::dvec3(patch.c[i][j].color), glm::dvec3(0));
}

TEST(SmoothColors, measure_along_the_chords_of_the_sides) {
  // A patch twice as long at its bottom: the same slope makes a tangent twice as long there.
  MeshParts parts = lattice({0, 1, 2}, {0, 1}, [](int, int j) { return Shade{0.1 + 0.2 * j}; });
  const auto corner = [&](double x, double y, double red) {
    return Value{{x, y}, {red, 0.25, 0.5, 1}};
  };
  parts.patches[0] = test::straight_patch(
      {corner(0, 0, 0.1), corner(1, 0, 0.3), corner(1, 1, 0.3), corner(-1, 1, 0.1)});
  const auto patches = with_smooth_colors(build_mesh(parts)).patches;
  // Below: slopes 0.2 / 2 and 0.2 / 1, so inside 0.15, at the left end 2 * 0.1 - 0.15.
  EXPECT_NEAR(patches[0].c[3][1].color.r, 0.05 * 2, 1e-12);
  EXPECT_NEAR(patches[0].c[3][2].color.r, 0.15 * 2, 1e-12);
  EXPECT_NEAR(patches[0].c[0][1].color.r, 0.2, 1e-12);
}

TEST(PaintedMesh, has_eight_by_eight_parts_of_each_patch_row_by_row) {
  const Mesh mesh = build_mesh(lattice({0, 8, 24}, {0, 8}, [](int i, int j) {
    return Shade{0.2 + 0.3 * ((i + j) % 2), 0.5 + 0.25 * j};
  }));
  const Mesh painted = painted_mesh(mesh);
  ASSERT_EQ(painted.face_count(), 128);
  EXPECT_EQ(validate(painted), std::vector<std::string>{});
  EXPECT_FALSE(painted.is_smooth());
  const auto smooth = with_smooth_colors(mesh).patches;
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 16; ++j) {
      const Patch part = painted.patch(Face{16 * i + j});
      const Value at = smooth[j / 8].at(i / 8.0, (j % 8) / 8.0);
      EXPECT_NEAR(part.c[0][0].position.x, j < 8 ? j : 8 + 2 * (j - 8), 1e-9);
      EXPECT_NEAR(part.c[0][0].position.y, i, 1e-9);
      EXPECT_NEAR(part.c[0][0].color.r, at.color.r, 1e-12);
      // Opacity is bilinear over the whole patch.
      EXPECT_NEAR(part.c[0][0].color.a, 0.5 + 0.25 * j / 8, 1e-12);
      Patch bilinear = part;
      make_color_bilinear(bilinear);
      EXPECT_LE(test::difference(part, bilinear), 1e-12);
    }
}

TEST(PaintedMesh, keeps_colours_within_their_range) {
  // Beside a level corner the parabola at the border swings out to 2 d.
  const Mesh mesh = build_mesh(lattice(
      {0, 1, 2, 3}, {0, 1}, [](int, int j) { return Shade{j == 1 || j == 2 ? 1.0 : 0.0}; }));
  const Mesh painted = painted_mesh(mesh);
  for (const Face f : painted.faces())
    for (int k = 0; k < 4; ++k) {
      EXPECT_GE(painted.patch(f).corner(k).color.r, 0);
      EXPECT_LE(painted.patch(f).corner(k).color.r, 1);
    }
}

TEST(SmoothMesh, is_painted_as_its_parts_by_both_rasterizers) {
  MeshParts parts =
      test::grid_parts({.rows = 3, .columns = 4, .position_noise = 0.1, .color_noise = 0.3},
                       *std::make_unique<std::mt19937>(4));
  const Mesh plain = build_mesh(parts);
  parts.smooth = true;
  const Mesh smooth = build_mesh(parts);
  const Frame frame = fit_frame(smooth, {}, 200);
  for (const auto& rasterizer : {make_software_rasterizer(), make_cairo_like_rasterizer()}) {
    EXPECT_EQ(rasterizer->paint(smooth, frame), rasterizer->paint(painted_mesh(smooth), frame));
    EXPECT_NE(rasterizer->paint(smooth, frame), rasterizer->paint(plain, frame));
  }
}

RunOptions line_options(double epsilon) {
  RunOptions options;
  options.method = "lines";
  options.epsilon = epsilon;
  options.resolution = 150;
  return options;
}

Mesh smooth_grid(int rows, int columns, unsigned seed) {
  std::mt19937 random(seed);
  MeshParts parts = test::grid_parts(
      {.rows = rows, .columns = columns, .position_noise = 0.05, .color_noise = 0.05}, random);
  parts.smooth = true;
  return build_mesh(parts);
}

TEST(SmoothMesh, loses_whole_lines_and_its_error_is_that_of_what_is_painted) {
  for (const double epsilon : {0.01, 0.05}) {
    const Mesh original = smooth_grid(5, 6, 3);
    Mesh mesh = original;
    const SimplifyResult result = simplify(mesh, line_options(epsilon));
    EXPECT_EQ(result.method, "lines");
    EXPECT_TRUE(mesh.is_smooth());
    EXPECT_TRUE(find_grid(mesh));
    EXPECT_EQ(validate(mesh), std::vector<std::string>{});
    EXPECT_LE(result.error, epsilon);
    EXPECT_NEAR(result.error, result.error_added_up, 1e-6);
    const auto rasterizer = make_software_rasterizer();
    const Image before = rasterizer->paint(painted_mesh(original), result.frame);
    const Image after = rasterizer->paint(painted_mesh(mesh), result.frame);
    EXPECT_NEAR(result.error, mean(make_metric(MetricKind::flip, before)->map(after)), 1e-12);
    if (epsilon == 0.05) {
      EXPECT_LT(result.patches_after, 30);
    }
  }
}

TEST(SmoothMesh, does_not_depend_on_the_number_of_threads) {
  std::vector<Patch> first;
  for (const int threads : {1, 3}) {
    Mesh mesh = smooth_grid(4, 5, 6);
    RunOptions options = line_options(0.05);
    options.threads = threads;
    simplify(mesh, options);
    EXPECT_LT(mesh.face_count(), 20);
    std::vector<Patch> left;
    for (const Face f : mesh.faces()) left.push_back(mesh.patch(f));
    if (first.empty()) first = left;
    EXPECT_EQ(left, first);
  }
}

TEST(SmoothMesh, is_refused_by_what_does_not_take_whole_lines) {
  Mesh mesh = smooth_grid(2, 2, 1);
  RunOptions options;
  options.resolution = 50;
  EXPECT_THROW(test::analyze_edges(mesh, options), InputError);
  EXPECT_THROW(test::analyze_regions(mesh, options), InputError);
  for (const std::string& method : method_names()) {
    if (suits(method_named(method), mesh)) continue;
    options.method = method;
    EXPECT_THROW(simplify(mesh, options), InputError) << method;
  }
}

}  // namespace
}  // namespace gradmesh
