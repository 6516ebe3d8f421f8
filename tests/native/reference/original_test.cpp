// What meshes are measured against: the picture of a mesh, or a picture as it is.
#include "reference/original.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <random>
#include <stdexcept>

#include "base/clamped_int.h"
#include "base/error.h"
#include "base/parallel.h"
#include "meshes.h"
#include "originals.h"
#include "pricing/price_table.h"
#include "raster/hidden.h"
#include "reference/layout.h"
#include "reference/reference.h"
#include "trial/measured_surface.h"

namespace gradmesh {
namespace {

using test::grid_mesh;
using test::picture_by;

/// The map that places a picture pixel for pixel.
const Affine as_it_is;

Mesh noisy_mesh(unsigned seed, double color_noise = 0.05) {
  return grid_mesh({.rows = 3, .columns = 4, .position_noise = 0.06, .color_noise = color_noise},
                   seed);
}

RgbaImage picture_from(int width, int height,
                       const std::function<std::array<std::uint8_t, 4>(int, int)>& pixel) {
  RgbaImage picture(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) picture.set_pixel(x, y, pixel(x, y));
  return picture;
}

RgbaImage random_picture(int width, int height, unsigned seed, bool is_opaque = true) {
  std::mt19937 random(seed);
  const auto level = [&] { return std::uint8_t(random() % 256); };
  return picture_from(width, height, [&](int, int) {
    const std::uint8_t r = level(), g = level(), b = level(), a = level();
    return std::array<std::uint8_t, 4>{r, g, b, is_opaque ? std::uint8_t(255) : a};
  });
}

Image opaque(const RgbaImage& picture) {
  Image image(picture.width, picture.height);
  std::copy_n(picture.samples.begin(), image.samples.size(), image.samples.begin());
  return image;
}

double error_of(const Mesh& mesh, const Reference& reference) {
  return MeasuredSurface(reference, mesh, false, nullptr).error().mean;
}

TEST(OriginalPicture, that_a_mesh_painted_is_painted_again_to_the_bit) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const Mesh mesh = noisy_mesh(seed);
    const Affine view = seed % 2 ? Affine() : Affine{{0.6, 0.8, 0.8, -0.6}, {30, -70}};
    const Frame frame = fit_frame(mesh, view, 90 + int(17 * seed));
    const Image painted = paint_whole(mesh, frame).image;
    const auto picture = picture_by(mesh, frame);
    EXPECT_EQ(picture->painted(frame).image, painted);

    // A part of a frame is painted as in the whole.
    Painting part(Window{7, 11, 40, 38});
    picture->paint(frame, part);
    Image same(part.window());
    copy(painted, part.window(), same);
    EXPECT_EQ(part.image, same);
  }
}

TEST(OriginalPicture, measures_meshes_as_the_mesh_that_painted_it_does) {
  for (const MetricKind metric : {MetricKind::flip, MetricKind::ssim})
    for (unsigned seed = 1; seed <= 4; ++seed) {
      const Mesh mesh = noisy_mesh(seed), changed = noisy_mesh(seed, 0.15);
      const Frame frame = fit_frame(mesh, {}, 120);
      const Reference of_mesh(mesh, frame, metric);
      const Reference of_picture(*picture_by(mesh, frame), frame, metric);
      EXPECT_EQ(error_of(mesh, of_picture), 0);
      EXPECT_GT(error_of(changed, of_mesh), 0.01);
      EXPECT_EQ(error_of(changed, of_picture), error_of(changed, of_mesh));
    }
}

/// At another resolution colours are interpolated and rounded once more, by about a level, which
/// FLIP has as 0.03. By no more than the mesh itself is off may the errors of others differ. The
/// outline, where a pixel of another size is seen, lies outside of the frame.
TEST(OriginalPicture, measures_meshes_alike_at_other_resolutions) {
  constexpr double scale = 0.4;
  Frame frame{144, 104};
  frame.to_pixels = Affine::scaling({scale, scale}) * Affine::translation({-20, -20});
  for (unsigned seed = 1; seed <= 4; ++seed)
    for (const double factor : {0.5, 0.7, 1.6, 2.0, 3.0}) {
      SCOPED_TRACE(factor);
      const Mesh mesh = noisy_mesh(seed), changed = noisy_mesh(seed, 0.3);
      Frame of_pixels;
      of_pixels.width = clamped_int(std::ceil(factor * frame.width), 1, 1000);
      of_pixels.height = clamped_int(std::ceil(factor * frame.height), 1, 1000);
      of_pixels.to_pixels = Affine::scaling(glm::dvec2(factor)) * frame.to_pixels;
      const Reference of_mesh(mesh, frame, MetricKind::flip);
      const Reference of_picture(*picture_by(mesh, of_pixels), frame, MetricKind::flip);
      const double off = error_of(mesh, of_picture);
      EXPECT_LT(off, 0.03);
      EXPECT_GT(error_of(changed, of_mesh), 2 * off);
      EXPECT_NEAR(error_of(changed, of_picture), error_of(changed, of_mesh), off);
    }
}

TEST(OriginalPicture, is_averaged_by_area_where_it_is_reduced) {
  for (const int factor : {2, 3, 7}) {
    const RgbaImage picture = random_picture(8 * factor, 5 * factor, unsigned(factor));
    Frame frame{8, 5};
    frame.to_pixels = Affine::scaling(glm::dvec2(1.0 / factor));
    const Image painted = original_of(picture, as_it_is)->painted(frame).image;
    for (int y = 0; y < frame.height; ++y)
      for (int x = 0; x < frame.width; ++x)
        for (int c = 0; c < 3; ++c) {
          double sum = 0;
          for (int i = 0; i < factor; ++i)
            for (int j = 0; j < factor; ++j) sum += *picture.at(factor * x + j, factor * y + i, c);
          EXPECT_NEAR(*painted.at(x, y, c), sum / (factor * factor), 0.501);
        }
  }
}

TEST(OriginalPicture, is_interpolated_where_it_is_enlarged) {
  const RgbaImage ramp = picture_from(9, 6, [](int x, int y) {
    return std::array<std::uint8_t, 4>{std::uint8_t(20 * x), std::uint8_t(40 * y), 77, 255};
  });
  constexpr int factor = 5;
  Frame frame{9 * factor, 6 * factor};
  frame.to_pixels = Affine::scaling(glm::dvec2(factor));
  const Painting painted = original_of(ramp, as_it_is)->painted(frame);
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x) {
      // Beyond the middle of the outermost pixels there is nothing to interpolate with.
      const double column = std::clamp((x + 0.5) / factor - 0.5, 0.0, 8.0);
      const double row = std::clamp((y + 0.5) / factor - 0.5, 0.0, 5.0);
      EXPECT_NEAR(*painted.image.at(x, y, 0), 20 * column, 0.501);
      EXPECT_NEAR(*painted.image.at(x, y, 1), 40 * row, 0.501);
      EXPECT_EQ(*painted.image.at(x, y, 2), 77);
      EXPECT_NE(*painted.top.at(x, y), 0u);
    }
}

TEST(OriginalPicture, covers_its_rectangle_and_nothing_beside_it) {
  const RgbaImage picture = random_picture(10, 6, 3);
  Frame frame{20, 20};
  const auto original = original_of(picture, Affine::translation({4, 9}));
  const Painting painted = original->painted(frame);
  const Window inside{4, 9, 14, 15};
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 20; ++x) {
      const bool is_inside = x >= inside.x0 && x < inside.x1 && y >= inside.y0 && y < inside.y1;
      EXPECT_EQ(*painted.top.at(x, y) != 0, is_inside);
      if (is_inside) continue;
      EXPECT_EQ(painted.image.pixel(x, y), (std::array<std::uint8_t, 3>{255, 255, 255}));
    }
  const Reference reference(*original, frame, MetricKind::flip);
  EXPECT_FALSE(reference.color_at({2, 12}));
  EXPECT_TRUE(reference.color_at({9.3, 12.1}));
  EXPECT_EQ(*reference.away_from_outline().at(3, 12), 0);
  EXPECT_FALSE(reference.outline_near({4, 12}));
  const auto [r, g, b, a] = picture.pixel(5, 3);
  EXPECT_LT(glm::distance(*reference.color_at({9.5, 12.5}), glm::dvec3(r, g, b) / 255.0), 1e-9);
}

TEST(OriginalPicture, is_turned_and_mirrored_with_the_view) {
  const RgbaImage picture = random_picture(12, 7, 4);
  const auto original = original_of(picture, as_it_is);
  Frame turned{7, 12};
  turned.to_pixels = {glm::dmat2(0, 1, -1, 0), {7, 0}};
  const Image painted = original->painted(turned).image;
  for (int y = 0; y < 7; ++y)
    for (int x = 0; x < 12; ++x) EXPECT_EQ(painted.pixel(6 - y, x), opaque(picture).pixel(x, y));

  Frame mirrored{12, 7};
  mirrored.to_pixels = {glm::dmat2(-1, 0, 0, 1), {12, 0}};
  EXPECT_EQ(original->painted(mirrored).image.pixel(1, 2), opaque(picture).pixel(10, 2));
}

TEST(OriginalPicture, shows_the_ground_as_far_as_it_is_translucent) {
  const RgbaImage picture = random_picture(15, 9, 5, false);
  const auto original = original_of(picture, as_it_is);
  const Frame frame{15, 9};
  ASSERT_TRUE(original->is_translucent());
  for (const Frame& on : {frame, on_black(frame)}) {
    const Image painted = original->painted(on).image;
    for (int y = 0; y < 9; ++y)
      for (int x = 0; x < 15; ++x)
        for (int c = 0; c < 3; ++c) {
          const double share = *picture.at(x, y, 3) / 255.0;
          EXPECT_NEAR(*painted.at(x, y, c), share * *picture.at(x, y, c) + (1 - share) * on.ground,
                      0.501);
        }
  }
  const Reference reference(*original, frame, MetricKind::flip);
  ASSERT_TRUE(reference.metric_on_black());
  EXPECT_EQ(reference.metric_on_black()->reference(), original->painted(on_black(frame)).image);

  const auto no_ground = original_of(random_picture(15, 9, 5), as_it_is);
  EXPECT_FALSE(no_ground->is_translucent());
  EXPECT_FALSE(Reference(*no_ground, frame, MetricKind::flip).metric_on_black());
}

/// Colours do not come from pixels in which nothing is seen.
TEST(OriginalPicture, weighs_colours_by_opacities) {
  const RgbaImage picture = picture_from(2, 1, [](int x, int) {
    return std::array<std::uint8_t, 4>{std::uint8_t(x ? 0 : 200), 0, 0, std::uint8_t(x ? 0 : 255)};
  });
  Frame one{1, 1};
  one.to_pixels = Affine::scaling({0.5, 1});
  one.ground = 0;
  EXPECT_EQ(*original_of(picture, as_it_is)->painted(one).image.at(0, 0), 100);
}

TEST(OriginalPicture, is_not_painted_in_hidden_pixels) {
  Frame frame{20, 20};
  const Outline seen{{{5, 0}, {20, 0}, {20, 20}, {5, 20}}};
  VisibleArea area;
  area.sets.push_back({{seen}});
  frame.hidden = std::make_shared<HiddenPixels>(area, frame);
  const RgbaImage picture = random_picture(20, 20, 6);
  const Painting painted = original_of(picture, as_it_is)->painted(frame);
  for (int y = 0; y < 20; ++y) {
    EXPECT_EQ(painted.image.pixel(4, y), (std::array<std::uint8_t, 3>{255, 255, 255}));
    EXPECT_EQ(*painted.top.at(4, y), 0u);
    EXPECT_EQ(painted.image.pixel(5, y), opaque(picture).pixel(5, y));
    EXPECT_NE(*painted.top.at(5, y), 0u);
  }
}

TEST(OriginalPicture, is_laid_out_as_a_mesh_over_its_rectangle) {
  const Mesh mesh = grid_mesh({.rows = 2, .columns = 3});
  const auto picture = original_of(random_picture(30, 20, 7), Affine::scaling({10, 10}));
  for (const Affine& view : {Affine(), Affine{{0.6, 0.8, 0.8, -0.6}, {30, -70}}}) {
    const Layout layout{.view = view, .padding = {.share = 0.03, .length = 2}};
    const Frame of_mesh = laid_out(*original_of(std::make_shared<const Mesh>(mesh)), layout, 140);
    const Frame of_picture = laid_out(*picture, layout, 140);
    EXPECT_EQ(of_picture.width, of_mesh.width);
    EXPECT_EQ(of_picture.height, of_mesh.height);
    for (const glm::dvec2 p : {glm::dvec2(0, 0), glm::dvec2(300, 200)})
      EXPECT_LT(glm::distance(of_picture.to_pixels.point(p), of_mesh.to_pixels.point(p)), 1e-9);
    const Painting a = picture->painted(of_picture), b = paint_whole(mesh, of_mesh);
    for (std::size_t i = 0; i < a.top.samples.size(); ++i)
      EXPECT_EQ(a.top.samples[i] != 0, b.top.samples[i] != 0);
  }
}

TEST(OriginalPicture, is_painted_the_same_on_any_number_of_threads) {
  const auto original = original_of(random_picture(90, 70, 8, false), as_it_is);
  Frame frame{50, 60};
  frame.to_pixels = {glm::dmat2(0.5, 0.3, -0.2, 0.4), {12, 3}};
  const auto painted_on = [&](int threads) {
    const ThreadLimit limit(threads);
    return original->painted(frame).image;
  };
  EXPECT_EQ(painted_on(1), painted_on(3));
}

TEST(OriginalPicture, has_pixels_and_a_place) {
  EXPECT_THROW(original_of(RgbaImage(0, 4), as_it_is), std::invalid_argument);
  const RgbaImage picture = random_picture(3, 3, 1);
  EXPECT_THROW(original_of(picture, Affine::scaling({1, 0})), std::invalid_argument);
  EXPECT_THROW(original_of(picture, Affine::scaling({1, std::nan("")})), std::invalid_argument);
  EXPECT_THROW(laid_out(*original_of(picture, Affine::scaling({1e70, 1})), {}, 100), InputError);
}

TEST(OriginalPicture, has_prices_of_its_own) {
  const Mesh mesh = noisy_mesh(1);
  const Frame frame = fit_frame(mesh, {}, 60);
  const RgbaImage first = random_picture(30, 20, 9);
  RgbaImage other = first, fainter = first;
  *other.at(29, 19, 2) ^= 1;
  *fainter.at(0, 0, 3) = 254;
  const auto key = [&](const Original& original) {
    return analysis_key(original, mesh, frame, MetricKind::flip);
  };
  const PriceTableKey of_first = key(*original_of(first, as_it_is));
  EXPECT_EQ(key(*original_of(first, as_it_is)), of_first);
  for (const auto& original :
       {original_of(other, as_it_is), original_of(fainter, as_it_is),
        original_of(first, Affine::translation({0, 1})),
        original_of(std::make_shared<const Mesh>(mesh)), picture_by(mesh, frame)})
    EXPECT_FALSE(key(*original) == of_first);
}

TEST(OriginalMesh, is_the_mesh_itself) {
  const auto mesh = std::make_shared<const Mesh>(noisy_mesh(2));
  const auto original = original_of(mesh);
  const Frame frame = fit_frame(*mesh, {}, 80);
  EXPECT_EQ(original->mesh(), mesh);
  EXPECT_FALSE(original->is_translucent());
  EXPECT_EQ(original->painted(frame).image, paint_whole(*mesh, frame).image);
  EXPECT_EQ(original->painted(frame).top, paint_whole(*mesh, frame).top);
  EXPECT_FALSE(original_of(std::shared_ptr<const Mesh>()));
  EXPECT_FALSE(picture_by(*mesh, frame)->mesh());
}

}  // namespace
}  // namespace gradmesh
