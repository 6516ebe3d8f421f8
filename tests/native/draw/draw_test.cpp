#include "draw/draw.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <string_view>

#include "draw/backdrop.h"
#include "draw/heat_scale.h"
#include "draw/svg_drawing.h"
#include "formats/svg/values/path.h"
#include "meshes.h"
#include "ops/split/split.h"
#include "raster/rasterizer.h"

namespace gradmesh {
namespace {

using test::between;
using test::grid_mesh;

/// Two rows of patches and, in the first, a T-junction.
Mesh mesh_with_junction() {
  Mesh mesh = grid_mesh({.rows = 2, .columns = 2, .position_noise = 0.1});
  Journal journal(mesh);
  split(journal, mesh.sides(Face{0})[0], 0.5);
  return mesh;
}

const Layer& layer(const Drawing& drawing, std::string_view name) {
  const auto found = std::ranges::find(drawing.layers, name, &Layer::name);
  EXPECT_NE(found, drawing.layers.end()) << name;
  return *found;
}

/// It would not outlive the drawing.
const Layer& layer(const Drawing&& drawing, std::string_view name) = delete;

bool says(const Drawing& drawing, const std::string& text) {
  return std::ranges::any_of(layer(drawing, "Legend").labels,
                             [&](const Label& l) { return l.text == text; });
}

int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++found;
  return found;
}

/// Lightness as the eye sees it, up to scale.
double luminance(const glm::dvec3& srgb) {
  const auto linear = [](double c) { return std::pow(c, 2.2); };
  return 0.2126 * linear(srgb.r) + 0.7152 * linear(srgb.g) + 0.0722 * linear(srgb.b);
}

TEST(HeatScale, gets_darker_all_the_way) {
  for (int i = 0; i < 200; ++i)
    EXPECT_GT(luminance(heat_color(i / 200.0)), luminance(heat_color((i + 1) / 200.0))) << i;
  EXPECT_EQ(hex_color(heat_color(0)), "#fcf9e6");
  EXPECT_EQ(hex_color(heat_color(1)), "#1d124b");
}

TEST(HeatScale, is_logarithmic_over_three_powers_of_ten) {
  const HeatScale scale(0.02);
  EXPECT_EQ(scale.position(0.02), 1);
  EXPECT_NEAR(scale.position(0.002), 2 / 3.0, 1e-12);
  EXPECT_NEAR(scale.position(0.0002), 1 / 3.0, 1e-12);
  for (const double below : {0.00002, 1e-9, 0.0, -0.001}) EXPECT_EQ(scale.position(below), 0);
  EXPECT_EQ(scale.position(0.5), 1);
}

TEST(Subject, is_seen_through_the_view) {
  const Mesh mesh = grid_mesh({.rows = 2, .columns = 4});
  const Subject subject(mesh, Affine::translation({10, 20}) * Affine::scaling({2, 3}));
  EXPECT_EQ(subject.box().low(), glm::dvec2(10, 20));
  EXPECT_EQ(subject.box().high(), glm::dvec2(810, 620));
  EXPECT_EQ(subject.unit(), 8);
  EXPECT_LT(glm::distance(subject.center(Face{0}), glm::dvec2(110, 170)), 1e-9);
  EXPECT_NEAR(subject.narrowness(Face{0}), 200, 1e-9);
  EXPECT_EQ(subject.mesh().curves().size(), 3u * 4 + 2 * 5);
}

TEST(Draw, edges_show_every_curve_point_and_junction) {
  const Mesh mesh = mesh_with_junction();
  const Drawing drawing = draw_edges(Subject(mesh, Affine{}));
  // Nine points of the grid, two ends of the split; its lower end lies on a curve between patches.
  EXPECT_EQ(layer(drawing, "Curves").shapes.size(), 14u);
  EXPECT_EQ(layer(drawing, "Points").shapes.size(), 11u);
  EXPECT_TRUE(says(drawing, "T-junctions: 1"));
  EXPECT_TRUE(says(drawing, "control points: 10"));
  EXPECT_TRUE(says(drawing, "patches: 5"));
  const auto& handles = layer(drawing, "Handles").shapes;
  EXPECT_EQ(count(handles[0].path, "L"), 2 * 14);

  const Mesh plain = grid_mesh();
  EXPECT_FALSE(says(draw_edges(Subject(plain, Affine{})), "T-junctions: 0"));
}

TEST(Draw, faces_are_numbered_in_the_mean_of_their_colors) {
  Mesh mesh = grid_mesh({.rows = 1, .columns = 1});
  const Drawing drawing = draw_faces(Subject(mesh, Affine{}));
  const Layer& patches = layer(drawing, "Patches");
  ASSERT_EQ(patches.shapes.size(), 1u);
  // Corners (0.2, 0.8, 0.3), (0.2, 0.2, 0.3), (0.7, 0.8, 0.3), (0.7, 0.2, 0.7).
  EXPECT_EQ(patches.shapes[0].style.fill, hex_color({0.45, 0.5, 0.4}));
  EXPECT_EQ(patches.labels[0].text, "0");
}

std::vector<EdgePrice> prices_of(const Mesh& mesh) {
  std::vector<EdgePrice> prices;
  for (const Halfedge h : inner_edges(mesh))
    prices.push_back({h, MergeObstacle::none, 0.0001 * double(prices.size())});
  return prices;
}

TEST(Draw, errors_are_colors_with_the_costliest_on_top) {
  const Mesh mesh = grid_mesh();
  std::vector<EdgePrice> prices = prices_of(mesh);
  ASSERT_EQ(prices.size(), 12u);
  prices[3] = {prices[3].edge, MergeObstacle::branch, std::numeric_limits<double>::infinity()};
  const Subject subject(mesh, Affine{});
  const Drawing drawing = draw_errors(subject, prices, "FLIP");
  const auto& edges = layer(drawing, "Single-edge errors").shapes;
  ASSERT_EQ(edges.size(), 11u);
  EXPECT_EQ(edges.front().style.stroke, HeatScale::color_at(0));
  EXPECT_EQ(edges.back().style.stroke, HeatScale::color_at(1));
  EXPECT_EQ(edges.back().path, subject.curve(prices.back().edge));
  EXPECT_NE(edges.back().title.find("0.0011"), std::string::npos);

  const auto& blocked = layer(drawing, "Unmergeable edges").shapes;
  ASSERT_EQ(blocked.size(), 1u);
  EXPECT_GT(blocked[0].style.dash, 0);
  EXPECT_NE(blocked[0].title.find(describe(MergeObstacle::branch).english()), std::string::npos);
  EXPECT_TRUE(says(drawing, "0.0011 (largest)"));
  EXPECT_TRUE(says(drawing, "Least: 0"));
  EXPECT_TRUE(says(drawing, "1 cannot be merged"));
}

TEST(Draw, errors_of_nothing_and_of_no_edges) {
  const Mesh mesh = grid_mesh();
  std::vector<EdgePrice> free = prices_of(mesh);
  for (EdgePrice& p : free) p.error = 0;
  const Drawing nothing = draw_errors(Subject(mesh, Affine{}), free, "");
  const auto& edges = layer(nothing, "Single-edge errors").shapes;
  EXPECT_EQ(edges.size(), 12u);
  for (const Shape& s : edges) EXPECT_EQ(s.style.stroke, HeatScale::color_at(0));
  const Mesh single = grid_mesh({.rows = 1, .columns = 1});
  const Drawing drawing = draw_errors(Subject(single, Affine{}), {}, "");
  EXPECT_TRUE(layer(drawing, "Single-edge errors").shapes.empty());
  EXPECT_EQ(layer(drawing, "Boundary").shapes.size(), 4u);
}

TEST(Draw, motorcycle_parts_beside_each_other_differ) {
  const Mesh mesh = grid_mesh({.rows = 2, .columns = 4});
  std::vector<EdgePrice> prices = prices_of(mesh);
  const std::array<Halfedge, 2> cut{between(mesh, Face{1}, Face{2}),
                                    between(mesh, Face{5}, Face{6})};
  for (EdgePrice& p : prices)
    p.error = std::ranges::any_of(cut, [&](Halfedge h) { return mesh.curve(h) == p.edge; }) ? 1 : 0;
  const MotorcycleGraph graph = motorcycle_graph(mesh, prices, 0.5);
  ASSERT_EQ(graph.parts.size(), 2u);
  const Drawing drawing = draw_motorcycle(Subject(mesh, Affine{}), graph, 0.5);
  const auto& parts = layer(drawing, "Parts").shapes;
  ASSERT_EQ(parts.size(), 8u);
  EXPECT_EQ(parts[0].style.fill, parts[5].style.fill);
  EXPECT_NE(parts[1].style.fill, parts[2].style.fill);
  EXPECT_TRUE(says(drawing, "2 cost more than 0.5"));
  EXPECT_TRUE(says(drawing, "parts: 2"));
}

TEST(Draw, regions_are_shown_one_by_one_or_all) {
  const Mesh mesh = grid_mesh({.rows = 2, .columns = 3});
  const std::vector<RegionPrice> all{
      {{Face{0}, 0, 1, 2}, {Face{0}, Face{1}}, 0.001},
      {{Face{0}, 0, 2, 3}, {Face{0}, Face{1}, Face{2}, Face{3}, Face{4}, Face{5}}, 0.02},
      {{Face{1}, 0, 2, 2}, {Face{1}, Face{2}, Face{4}, Face{5}}, 0.01}};
  const std::vector<RegionPrice> regions = regions_with(all, Face{0});
  ASSERT_EQ(regions.size(), 2u);
  const Subject subject(mesh, Affine{});
  const Drawing one = draw_regions(subject, Face{0}, regions, 1),
                both = draw_regions(subject, Face{0}, regions, -1);
  EXPECT_EQ(layer(one, "Regions").shapes.size(), 3u);
  EXPECT_EQ(layer(both, "Regions").shapes.size(), 5u);
  // The border of 2 x 3 patches has ten sides, and its area six patches.
  EXPECT_EQ(count(layer(one, "Regions").shapes[0].path, "Z"), 6);
  EXPECT_EQ(count(layer(one, "Regions").shapes[1].path, "C"), 10);
  for (const char* text : {"1 × 2", "0.001", "2 × 3", "0.02"}) EXPECT_TRUE(says(one, text)) << text;
  const auto& labels = layer(one, "Legend").labels;
  const auto shown = std::ranges::find(labels, "2 × 3", &Label::text);
  EXPECT_TRUE(shown->bold);
  EXPECT_TRUE(says(draw_regions(subject, Face{0}, {}, 0), "No region within epsilon holds it."));
}

TEST(SvgDrawing, names_are_escaped_and_everything_is_inside_the_box) {
  const Mesh mesh = mesh_with_junction();
  const Subject subject(mesh, Affine{});
  Drawing drawing = draw_edges(subject);
  drawing.title = "<a & \"b\">";
  const std::string text = svg_text(drawing);
  EXPECT_NE(text.find("<title>&lt;a &amp; &quot;b&quot;&gt;</title>"), std::string::npos);
  EXPECT_EQ(text.find("image"), std::string::npos);
  for (const Layer& l : drawing.layers) {
    for (const Shape& s : l.shapes) {
      const Box box = path_box(s.path).value();
      EXPECT_TRUE(box.low().x >= drawing.box.low().x && box.high().x <= drawing.box.high().x)
          << l.name;
      EXPECT_TRUE(box.low().y >= drawing.box.low().y && box.high().y <= drawing.box.high().y)
          << l.name;
    }
  }
}

TEST(Backdrop, lies_where_the_mesh_is) {
  const Mesh mesh = grid_mesh({.rows = 1, .columns = 2});
  const Affine view = Affine::translation({7, 3}) * Affine::scaling({0.1, 0.1});
  const Frame frame = fit_frame(mesh, view, 103, {.share = 0.015});
  const Image painted = make_software_rasterizer()->paint(mesh, frame);
  const PlacedImage picture = backdrop(painted, frame, view, false);
  EXPECT_EQ(picture.image, painted);
  // 20 x 10 units and a margin of 0.3; the height is cut to whole pixels.
  EXPECT_NEAR(picture.low.x, 6.7, 1e-9);
  EXPECT_NEAR(picture.low.y, 2.7, 1e-9);
  EXPECT_NEAR(picture.high.x, 27.3, 1e-9);
  EXPECT_NEAR(picture.high.y, 2.7 + 20.6 / 103 * frame.height, 1e-9);
  const PlacedImage gray = backdrop(painted, frame, view, true);
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x) {
      const auto [r, g, b] = gray.image.pixel(x, y);
      ASSERT_EQ(r, g);
      ASSERT_EQ(r, b);
    }
}

}  // namespace
}  // namespace gradmesh
