#include <gtest/gtest.h>

#include <hwy/targets.h>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "base/error.h"
#include "base/parallel.h"
#include "form/written_patch.h"
#include "mesh/boundary.h"
#include "random_meshes.h"
#include "raster/fill.h"
#include "raster/painter.h"
#include "raster/rasterizer.h"
#include "raster/tessellate.h"

namespace gradmesh {
namespace {

using test::grid_mesh;
using test::grid_parts;

Mesh random_mesh(unsigned seed, double noise, int steps = 25) {
  const MeshParts parts =
      grid_parts({.rows = 4, .columns = 4, .position_noise = noise, .color_noise = 0.3}, seed);
  return test::changed_mesh(parts, seed, steps, 3);
}

const Window everywhere{-100000, -100000, 100000, 100000};

std::vector<FaceShape> shapes_of(const Mesh& mesh, const Frame& frame) {
  Tessellator tessellator;
  tessellator.start(mesh, frame);
  std::vector<FaceShape> shapes;
  for (const Face f : mesh.faces())
    tessellator.tessellate(f, mesh.patch(f), everywhere, shapes.emplace_back());
  return shapes;
}

/// The boundary, one loop, of a mesh as it is cut into straight pieces, in grid units.
std::vector<glm::dvec2> boundary_of(const Mesh& mesh, const Frame& frame) {
  std::vector<glm::dvec2> boundary;
  Outlines outlines;
  outlines.start(mesh, frame);
  const std::vector<std::vector<Halfedge>> loops = boundary_loops(mesh);
  for (const Halfedge leaf : loops.front()) {
    const std::vector<Outlines::Cut>& cuts = outlines.along(leaf);
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
      boundary.emplace_back(cuts[i].point.x, cuts[i].point.y);
  }
  return boundary;
}

bool inside(const std::vector<glm::dvec2>& polygon, glm::dvec2 p) {
  bool in = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    // A centre exactly on the line counts as right of it, as in find_parameters.
    if ((a.y <= p.y) != (b.y <= p.y) && a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x) <= p.x)
      in = !in;
  }
  return in;
}

/// Calls f(x, y, u, v).
template <class F>
void for_each_covered(const Parameters& parameters, const F& f) {
  const Window window = parameters.window;
  for (int y = window.y0; y < window.y1; ++y)
    for (int x = window.x0; x < window.x1; ++x) {
      const std::size_t at = parameters.offset(x, y);
      if (parameters.u[at] != Parameters::not_covered) f(x, y, parameters.u[at], parameters.v[at]);
    }
}

TEST(Raster, every_pixel_is_covered_exactly_once) {
  int covered = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    const Mesh mesh = random_mesh(seed, 0.08);
    const Frame frame = fit_frame(mesh, {}, 157);
    const std::vector<glm::dvec2> boundary = boundary_of(mesh, frame);
    Raster<int, 1> count(frame.width, frame.height);
    Parameters parameters;
    const auto count_covered = [&](const FaceShape& shape) {
      find_parameters(shape, frame.window(), parameters);
      for_each_covered(parameters, [&](int x, int y, float, float) { ++*count.at(x, y); });
    };
    for (const FaceShape& shape : shapes_of(mesh, frame)) {
      if (shape.traced) count_covered(shape);
      for (const Triangle& triangle : shape.triangles) {
        FaceShape one = shape;
        one.triangles = {triangle};
        count_covered(one);
      }
    }
    for (int y = 0; y < frame.height; ++y)
      for (int x = 0; x < frame.width; ++x) {
        const int expected = inside(boundary, glm::dvec2(256 * x + 128, 256 * y + 128)) ? 1 : 0;
        covered += expected;
        ASSERT_EQ(*count.at(x, y), expected) << "seed " << seed << " pixel " << x << ", " << y;
      }
  }
  EXPECT_GT(covered, 100000);
}

/// The largest distance, in pixels, between the points of a triangle and those of the surface with
/// the same parameters: at its corners, the middles of its sides, and its centre.
double distance_of(const std::array<Vertex, 3>& t, const Patch& patch, const Frame& frame) {
  double most = 0;
  for (const auto& w : {std::array{1., 0., 0.},
                        {.5, .5, 0.},
                        {0., .5, .5},
                        {.5, 0., .5},
                        {1 / 3., 1 / 3., 1 / 3.}}) {
    double x = 0, y = 0, u = 0, v = 0;
    for (int k = 0; k < 3; ++k) {
      x += w[k] * double(t[k].x) / 256;
      y += w[k] * double(t[k].y) / 256;
      u += w[k] * t[k].u;
      v += w[k] * t[k].v;
    }
    const glm::dvec2 p = frame.to_pixels.point(patch.at(u, v).position);
    most = std::max(most, glm::length(p - glm::dvec2(x, y)));
  }
  return most;
}

/// Whether Newton's method follows at these parameters.
bool is_refined(const Refinement& refinement, float u, float v) {
  return refinement.needed &&
         (refinement.everywhere || (refinement.cells[Folds::cell(u)] >> Folds::cell(v) & 1) != 0);
}

TEST(Raster, everything_is_within_a_tenth_of_a_pixel_of_the_surface) {
  int refined = 0, both = 0;
  for (const int resolution : {60, 700, 4000})
    for (unsigned seed = 0; seed < 5; ++seed) {
      const Mesh mesh = random_mesh(seed, seed % 2 == 0 ? 0.2 : 0.6, 10);
      const Frame frame = fit_frame(mesh, {}, resolution);
      const std::vector<FaceShape> shapes = shapes_of(mesh, frame);
      double most = 0;
      std::size_t i = 0;
      for (const Face f : mesh.faces()) {
        const FaceShape& shape = shapes[i++];
        const Patch patch = mesh.patch(f);
        (shape.refinement.everywhere ? refined : both) += shape.refinement.needed;
        if (shape.traced)
          for (std::size_t k = 0; k < shape.vertices.size(); ++k) {
            const Vertex &a = shape.vertices[k],
                         &b = shape.vertices[(k + 1) % shape.vertices.size()];
            most = std::max(most, distance_of({a, b, b}, patch, frame));
          }
        for (const auto& [a, b, c] : shape.triangles) {
          const Vertex va = shape.vertices[a], vb = shape.vertices[b], vc = shape.vertices[c];
          // The outline's edges, and all of the triangle where that is what is painted.
          if ((va.u == vb.u && (va.u == 0 || va.u == 1)) ||
              (va.v == vb.v && (va.v == 0 || va.v == 1)))
            most = std::max(most, distance_of({va, vb, vb}, patch, frame));
          if (!is_refined(shape.refinement, (va.u + vb.u + vc.u) / 3, (va.v + vb.v + vc.v) / 3))
            most = std::max(most, distance_of({va, vb, vc}, patch, frame));
        }
        Parameters parameters;
        find_parameters(shape, frame.window(), parameters);
        for_each_covered(parameters, [&](int x, int y, float u, float v) {
          const glm::dvec2 p = frame.to_pixels.point(patch.at(u, v).position);
          most = std::max(most, glm::length(p - glm::dvec2(x + 0.5, y + 0.5)));
        });
      }
      EXPECT_LE(most, 0.1) << "seed " << seed << " at " << resolution;
    }
  EXPECT_GT(refined, 50);
  EXPECT_GT(both, 20);
}

/// A straight patch is its own inverse: (u, v) at each point is known.
Patch inverse_patch() {
  return test::straight_patch({Value{{0, 0}, {1, 0, 0, 1}}, Value{{100, 0}, {0, 1, 0, 1}},
                               Value{{100, 50}, {0, 0, 1, 0.4}}, Value{{0, 50}, {1, 1, 1, 0}}});
}

class ColorModels : public ::testing::TestWithParam<ColorModel> {};
INSTANTIATE_TEST_SUITE_P(Raster, ColorModels,
                         ::testing::Values(ColorModel::bilinear, ColorModel::bicubic));

TEST_P(ColorModels, colors_are_those_of_the_surface_at_the_centre) {
  const Patch patch = inverse_patch();
  const Mesh mesh = build_mesh({{patch}, {}, GetParam()});
  const Frame frame = fit_frame(mesh, {}, 300);
  const Image image = make_software_rasterizer()->paint(mesh, frame);
  const Affine back = frame.to_pixels.inverse();
  int inside_pixels = 0;
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x) {
      const glm::dvec2 p = back.point({x + 0.5, y + 0.5});
      const double u = p.y / 50, v = p.x / 100;
      const bool in = u >= 0 && u < 1 && v >= 0 && v < 1;
      inside_pixels += in;
      const glm::dvec4 c = in ? patch.at(u, v).color : glm::dvec4(0);
      for (int k = 0; k < 3; ++k) {
        const double expected = 255 * (c.a * c[k] + 1 - c.a);
        ASSERT_NEAR(*image.at(x, y, k), expected, 0.55) << x << ", " << y;
      }
    }
  EXPECT_GT(inside_pixels, 30000);
}

TEST(CairoLike, colors_are_those_of_a_point_in_the_pixel) {
  const Patch patch = inverse_patch();
  const Mesh mesh = build_mesh({{patch}, {}, ColorModel::bilinear});
  const Frame frame = fit_frame(mesh, {}, 301);
  const Image image = make_cairo_like_rasterizer()->paint(mesh, frame);
  const Affine back = frame.to_pixels.inverse();
  int covered = 0;
  double bias = 0;
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x) {
      const glm::dvec2 low = back.point({x, y}), high = back.point({x + 1, y + 1});
      const bool touched = high.x >= 0 && low.x <= 100 && high.y >= 0 && low.y <= 50;
      covered += touched;
      // The patch's colours between the pixel's corners; colour is bilinear, so also in it.
      glm::dvec3 least(255), most(touched ? 0 : 255);
      for (const glm::dvec2 p : {low, high, glm::dvec2(low.x, high.y), glm::dvec2(high.x, low.y)}) {
        const glm::dvec4 c =
            patch.at(std::clamp(p.y / 50, 0., 1.), std::clamp(p.x / 100, 0., 1.)).color;
        const glm::dvec3 seen = 255.0 * (c.a * glm::dvec3(c) + 1.0 - c.a);
        if (touched) {
          least = glm::min(least, seen);
          most = glm::max(most, seen);
        }
      }
      // Two roundings down, and the steps of colour that are rounded along a curve.
      for (int k = 0; k < 3; ++k) {
        ASSERT_GE(*image.at(x, y, k), least[k] - 2) << x << ", " << y;
        ASSERT_LE(*image.at(x, y, k), most[k] + 2) << x << ", " << y;
      }
      const glm::dvec2 centre = 0.5 * (low + high);
      if (centre.x > 2 && centre.x < 98 && centre.y > 2 && centre.y < 10) {
        const glm::dvec4 c = patch.at(centre.y / 50, centre.x / 100).color;
        bias += 255 * (c.a * c.r + 1 - c.a) - *image.at(x, y, 0);
      }
    }
  EXPECT_GT(covered, 30000);
  // Red falls with v near the top, and samples lie towards the larger v.
  EXPECT_GT(bias, 0);
}

TEST(CairoLike, patches_leave_no_holes) {
  // A pixel of the surface is white only where no patch paints: the meshes hold no white.
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Mesh mesh = random_mesh(seed, 0.08);
    const Frame frame = fit_frame(mesh, {}, 157);
    const std::vector<glm::dvec2> boundary = boundary_of(mesh, frame);
    const Image image = make_cairo_like_rasterizer()->paint(mesh, frame);
    int inside_pixels = 0;
    for (int y = 0; y < frame.height; ++y)
      for (int x = 0; x < frame.width; ++x) {
        if (!inside(boundary, glm::dvec2(256 * x + 128, 256 * y + 128))) continue;
        ++inside_pixels;
        const std::array<std::uint8_t, 3> white{255, 255, 255};
        ASSERT_NE(image.pixel(x, y), white) << "seed " << seed << " pixel " << x << ", " << y;
      }
    EXPECT_GT(inside_pixels, 3000);
  }
}

Painting part_of(const Painting& whole, Window window) {
  Painting part(window);
  copy(whole, window, part);
  return part;
}

void expect_same_in_windows(const Mesh& mesh, int resolution) {
  const Frame frame = fit_frame(mesh, {}, resolution);
  Painting whole;
  {
    const ThreadLimit one(1);
    whole = paint_whole(mesh, frame);
  }
  EXPECT_EQ(make_software_rasterizer()->paint(mesh, frame), whole.image);
  std::mt19937 random(1);
  for (int round = 0; round < 50; ++round) {
    const auto in = [&](int n) { return int(random() % unsigned(n)); };
    const Window window{in(frame.width), in(frame.height), in(frame.width + 20),
                        in(frame.height + 20)};
    Painting part(window.clipped(frame.window()));
    if (part.window().empty()) continue;
    paint_whole(mesh, frame, part);
    const Painting expected = part_of(whole, part.window());
    EXPECT_EQ(part.image, expected.image);
    EXPECT_EQ(part.top, expected.top);
  }
}

TEST(Raster, windows_and_threads_do_not_change_a_pixel) {
  expect_same_in_windows(random_mesh(3, 0.3), 211);
  // With triangles that are too large for 32 bits.
  expect_same_in_windows(build_mesh({{inverse_patch()}, {}, ColorModel::bicubic}), 700);
}

/// Each kind of vectors that the program has and this processor can, down to none.
TEST(Raster, vectors_do_not_change_a_pixel) {
  const std::array meshes{random_mesh(3, 0.3), random_mesh(4, 0.8),
                          build_mesh({{inverse_patch()}, {}, ColorModel::bicubic})};
  for (const Mesh& mesh : meshes) {
    const Frame frame = fit_frame(mesh, {}, 500);
    const Painting expected = paint_whole(mesh, frame);
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
      hwy::SetSupportedTargetsForTest(target);
      const Painting painting = paint_whole(mesh, frame);
      hwy::SetSupportedTargetsForTest(0);
      EXPECT_EQ(painting.image, expected.image) << hwy::TargetName(target);
      EXPECT_EQ(painting.top, expected.top) << hwy::TargetName(target);
    }
  }
}

/// How many pixels are known to hide other faces.
int expect_up_to_date(const Painting& painting, const Painting& afresh) {
  EXPECT_EQ(painting.image, afresh.image);
  int hiding = 0;
  for (std::size_t i = 0; i < afresh.top.samples.size(); ++i) {
    const TopFace top(painting.top.samples[i]), expected(afresh.top.samples[i]);
    EXPECT_EQ(top.face(), expected.face());
    // Whether there still is a face below need not be known.
    EXPECT_GE(top.covers_others(), expected.covers_others());
    hiding += expected.covers_others();
  }
  return hiding;
}

struct RepaintCase {
  double position_noise;
  ColorModel model;
};
class Repaint : public ::testing::TestWithParam<RepaintCase> {};
INSTANTIATE_TEST_SUITE_P(Raster, Repaint,
                         ::testing::Values(RepaintCase{0.1, ColorModel::bilinear},
                                           RepaintCase{0.8, ColorModel::bilinear},
                                           RepaintCase{0.8, ColorModel::bicubic}),
                         [](const auto& test) {
                           return std::string(test.param.position_noise < 0.5 ? "flat" : "folded") +
                                  (test.param.model == ColorModel::bilinear ? "_bilinear"
                                                                            : "_bicubic");
                         });

TEST_P(Repaint, is_as_painting_afresh) {
  int hiding = 0;
  for (unsigned seed = 0; seed < 8; ++seed) {
    std::mt19937 random(seed);
    Mesh mesh = build_mesh(grid_parts({.rows = 5,
                                       .columns = 4,
                                       .position_noise = GetParam().position_noise,
                                       .color_noise = 0.3,
                                       .color_model = GetParam().model},
                                      random));
    Journal journal(mesh);
    const Frame frame = fit_frame(mesh, {}, 150);
    const auto bounds = [&] {
      std::vector<Window> of_faces(mesh.face_slots());
      for (const Face f : mesh.faces()) of_faces[f.value] = pixel_bounds(mesh.patch(f), frame);
      return of_faces;
    };
    Painter painter;
    Painting whole = paint_whole(mesh, frame);
    for (int step = 0; step < 20; ++step) {
      // An operation, or the last one taken back.
      const bool undo = step % 3 == 2;
      const Painting before = whole;
      const std::vector<Window> bounds_before = bounds();
      if (!undo) test::change_at_random(journal, random, 3);
      const std::vector<Face> touched = journal.touched_since(journal.depth() - 1);
      if (undo) journal.undo();
      Window within;
      for (const std::vector<Window>& of_faces : {bounds_before, bounds()})
        for (const Face f : touched)
          if (std::size_t(f.value) < of_faces.size()) within = within.united(of_faces[f.value]);

      painter.repaint(mesh, frame, touched, within, whole);
      const Painting afresh = paint_whole(mesh, frame);
      hiding += expect_up_to_date(whole, afresh);

      const auto in = [&](int n) { return int(random() % unsigned(n)); };
      const int x = in(frame.width), y = in(frame.height);
      const Window window{x, y, x + 1 + in(frame.width - x), y + 1 + in(frame.height - y)};
      Painting part = part_of(before, window);
      painter.repaint(mesh, frame, touched, within, part);
      expect_up_to_date(part, part_of(afresh, window));
      ASSERT_FALSE(HasFailure()) << "seed " << seed << " step " << step;
    }
  }
  if (GetParam().position_noise > 0.5) {
    EXPECT_GT(hiding, 10000);
  }
}

TEST(Raster, where_a_patch_folds_the_larger_v_lies_on_top) {
  // The top and bottom sides run out to x = 130 and back: columns near v = 1 cover earlier ones.
  std::array<Value, 4> corners{Value{{0, 0}, {1, 0, 0, 1}}, Value{{60, 0}, {0, 0, 1, 1}},
                               Value{{60, 100}, {0, 0, 1, 1}}, Value{{0, 100}, {1, 0, 0, 1}}};
  Patch patch = test::straight_patch(corners);
  for (const int i : {0, 3}) {
    patch.c[i][1].position = {500, 0};
    patch.c[i][2].position = {-200, 0};
  }
  for (const int i : {1, 2})
    for (const int j : {1, 2}) patch.c[i][j].position = {0, 0};
  const Mesh mesh = build_mesh({{patch}, {}, ColorModel::bilinear});
  const Frame frame = fit_frame(mesh, {}, 200);
  const Image image = make_software_rasterizer()->paint(mesh, frame);
  int folded = 0;
  for (int x = 0; x < frame.width; ++x) {
    const double wanted = frame.to_pixels.inverse().point({x + 0.5, 100.0}).x;
    double v = -1;
    int crossings = 0;
    for (int i = 0; i < 20000; ++i) {
      const double a = patch.at(0.5, i / 20000.).position.x;
      const double b = patch.at(0.5, (i + 1) / 20000.).position.x;
      if ((a <= wanted) != (b <= wanted)) {
        v = (i + 0.5) / 20000;
        ++crossings;
      }
    }
    // Close to the turning point a tenth of a pixel is a long way in v.
    const double slope = std::abs(patch.derivative_v(0.5, v).position.x);
    if (v < 0 || slope < 60) continue;
    folded += crossings > 1;
    EXPECT_NEAR(*image.at(x, frame.height / 2, 2), 255 * v, 3) << x;
  }
  EXPECT_GT(folded, 20);
}

TEST(Frame, follows_the_paper) {
  const Mesh mesh = grid_mesh({.rows = 1, .columns = 2});
  const Frame frame = fit_frame(mesh, {}, 700);
  EXPECT_EQ(frame.width, 700);
  // 200 x 100 units and 3 more on every side.
  EXPECT_EQ(frame.height, int(106.0 * 700 / 206));
  EXPECT_NEAR(frame.to_pixels.point({0, 0}).x, 3.0 * 700 / 206, 1e-9);
}

TEST(Frame, refuses_meshes_that_no_numbers_hold) {
  const Mesh mesh = grid_mesh();
  EXPECT_EQ(fit_frame(mesh, Affine::scaling({1e50, 1e50}), 100).width, 100);
  EXPECT_EQ(fit_frame(mesh, Affine::scaling({1e-50, 1e-50}), 100).width, 100);
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double factor : {0.0, 1e-300, 1e300, infinity, std::nan("")})
    EXPECT_THROW(fit_frame(mesh, Affine::scaling({factor, factor}), 100), InputError) << factor;
  EXPECT_THROW(fit_frame(mesh, Affine::translation({0, infinity}), 100), InputError);
}

TEST(Written, colors_are_rounded_and_near_coons_is_coons) {
  const Patch patch = grid_parts({.position_noise = 0.2, .color_noise = 0.2}, 5).patches[4];
  const Patch exact = as_written(patch, 0);
  EXPECT_TRUE(needs_tensor(patch, 0.01));
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) EXPECT_EQ(exact.c[i][j].position, patch.c[i][j].position);
  for (int k = 0; k < 4; ++k)
    for (int n = 0; n < 3; ++n) {
      const double level = exact.corner(k).color[n] * 255;
      EXPECT_NEAR(level, std::round(level), 1e-9);
      EXPECT_NEAR(level, patch.corner(k).color[n] * 255, 0.5 + 1e-9);
    }
  const Patch coons = as_written(patch, 1e9);
  EXPECT_FALSE(needs_tensor(coons, 1e-9));
  for (int k = 0; k < 4; ++k)
    EXPECT_EQ(coons.side(k).at(0.37).position, patch.side(k).at(0.37).position);
}

}  // namespace
}  // namespace gradmesh
