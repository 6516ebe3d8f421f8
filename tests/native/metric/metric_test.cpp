#include "metric/metric.h"

#include <gtest/gtest.h>
#include <hwy/highway.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "base/parallel.h"
#include "files/image_file.h"
#include "metric_images.h"
#include "naive_metrics.h"

namespace gradmesh {
namespace {

using test::all_kinds;
using test::expect_equal_bits;
using test::filled;
using test::RandomImages;
using test::title;

/// Distance along the axes, as `reach` counts it.
int distance(int x0, int y0, int x1, int y1) {
  return std::max(std::abs(x0 - x1), std::abs(y0 - y1));
}

struct Bounds {
  double lower, exact, upper;
};

Bounds naive_bounds(MetricKind kind, const Image& a, const Image& b, int x, int y) {
  if (kind == MetricKind::ssim) {
    const double exact = naive::one_minus_ssim(a, b, x, y);
    return {exact, exact, exact};
  }
  // The power 0.7 is infinitely steep at 0. There a float's rounding shows: the colours, of a
  // range of 100, are good to a millionth of it.
  constexpr double resolution = 1e-6 * 100;
  const double colour = naive::flip_colour(a, b, x, y), feature = naive::flip_feature(a, b, x, y);
  return {naive::flip(std::max(0.0, colour - resolution), feature), naive::flip(colour, feature),
          naive::flip(colour + resolution, feature)};
}

void expect_near_naive(MetricKind kind, const Image& a, const Image& b) {
  constexpr double tolerance = 1e-5;
  const Plane map = make_metric(kind, a)->map(b);
  double total = 0;
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      const Bounds bounds = naive_bounds(kind, a, b, x, y);
      total += bounds.exact;
      ASSERT_GE(*map.at(x, y), bounds.lower - tolerance) << title(kind) << " " << x << ", " << y;
      ASSERT_LE(*map.at(x, y), bounds.upper + tolerance) << title(kind) << " " << x << ", " << y;
    }
  }
  EXPECT_NEAR(mean(map), total / double(map.samples.size()), 2e-6) << title(kind);
}

TEST(Metric, agrees_with_the_definitions_in_double_precision) {
  RandomImages random(1);
  const int sizes[][2] = {{1, 1}, {1, 9}, {23, 1}, {2, 3}, {7, 5}, {10, 11}, {25, 14}};
  for (const auto& [width, height] : sizes) {
    SCOPED_TRACE(std::to_string(width) + " x " + std::to_string(height));
    const Image noise = random.noise(width, height), gradient = random.gradient(width, height);
    const Image other_noise = random.noise(width, height);
    for (const MetricKind kind : all_kinds) {
      expect_near_naive(kind, noise, other_noise);
      expect_near_naive(kind, noise, random.edited(noise));
      expect_near_naive(kind, gradient, noise);
      expect_near_naive(kind, gradient, random.edited(gradient));
      expect_near_naive(kind, gradient, random.gradient(width, height));
    }
  }
}

// There a variance is a small difference of large squares.
TEST(Metric, ssim_of_bright_nearly_flat_images_is_as_exact) {
  RandomImages random(11);
  Image a = filled(24, 24, 253, 128, 1), b = a;
  for (Image* image : {&a, &b})
    for (auto& sample : image->samples) sample += std::uint8_t(random.from(0, 2));
  const Plane map = make_metric(MetricKind::ssim, a)->map(b);
  for (int y = 0; y < 24; ++y)
    for (int x = 0; x < 24; ++x)
      ASSERT_NEAR(*map.at(x, y), naive::one_minus_ssim(a, b, x, y), 1e-7) << x << ", " << y;
}

TEST(Metric, flat_images_have_known_distances) {
  const auto distance_of = [](MetricKind kind, const Image& a, const Image& b) {
    return mean(make_metric(kind, a)->map(b));
  };
  const Image green = filled(13, 9, 0, 255, 0), blue = filled(13, 9, 0, 0, 255);
  EXPECT_NEAR(distance_of(MetricKind::flip, green, blue), 1, 1e-6);

  // Without any structure only the luminance factor of SSIM is left.
  const double c1 = 6.5025;
  const auto luminance = [&](double a, double b) {
    return (2 * a * b + c1) / (a * a + b * b + c1);
  };
  EXPECT_NEAR(
      distance_of(MetricKind::ssim, filled(20, 20, 10, 200, 90), filled(20, 20, 10, 100, 0)),
      1 - (1 + luminance(200, 100) + luminance(90, 0)) / 3, 1e-5);
}

TEST(Metric, equal_images_have_no_distance_at_all) {
  RandomImages random(2);
  for (const MetricKind kind : all_kinds) {
    for (const Image& image : {random.noise(70, 45), random.gradient(33, 64), random.noise(1, 1)}) {
      expect_equal_bits(make_metric(kind, image)->map(image), Plane(image.width, image.height));
    }
  }
}

// The pixels between two far differences are computed, not left out, and must come to 0 all the
// same: the reference and the test go through the same arithmetic.
TEST(Metric, pixels_among_equal_ones_have_no_distance_at_all) {
  RandomImages random(3);
  for (const MetricKind kind : all_kinds) {
    const Image reference = random.noise(90, 30);
    Image test = reference;
    *test.at(0, 15, 0) ^= 255;
    *test.at(89, 15, 0) ^= 255;
    const auto metric = make_metric(kind, reference);
    const int reach = metric->reach();
    const Plane map = metric->map(test);
    for (int y = 0; y < 30; ++y)
      for (int x = reach + 1; x < 89 - reach; ++x) ASSERT_EQ(*map.at(x, y), 0) << x << ", " << y;
    EXPECT_GT(*map.at(0, 15), 0);
    EXPECT_GT(*map.at(89, 15), 0);
  }
}

TEST(Metric, flip_is_symmetric) {
  RandomImages random(4);
  const Image a = random.noise(40, 25), b = random.gradient(40, 25);
  expect_equal_bits(make_metric(MetricKind::flip, a)->map(b),
                    make_metric(MetricKind::flip, b)->map(a));
}

TEST(Metric, a_window_holds_the_bits_of_the_whole_frame) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    RandomImages random(seed);
    const int width = random.from(1, 80), height = random.from(1, 80);
    const Image reference =
        seed % 2 == 0 ? random.noise(width, height) : random.gradient(width, height);
    const Image test = seed % 3 == 0 ? random.noise(width, height) : random.edited(reference);
    const MetricKind kind = all_kinds[random.from(0, 1)];
    const auto metric = make_metric(kind, reference);
    const Plane whole = metric->map(test);
    for (int repeat = 0; repeat < 5; ++repeat) {
      const Window window = random.part_of(reference.window());
      constexpr float untouched = -7;
      Plane part(width, height, untouched);
      metric->fill_map(test, window, part);
      for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
          const bool inside = !window.clipped({x, y, x + 1, y + 1}).empty();
          ASSERT_EQ(*part.at(x, y), inside ? *whole.at(x, y) : untouched)
              << title(kind) << " at " << x << ", " << y;
        }
      }
    }
  }
}

/// The part of a raster that covers a window.
template <class Sample, int Channels>
Raster<Sample, Channels> part(const Raster<Sample, Channels>& whole, Window window) {
  Raster<Sample, Channels> result(window);
  copy(whole, window, result);
  return result;
}

/// Weights from a quarter to 4 in every other frame; null in the others.
Metric::Weights some_weights(RandomImages& random, Window frame) {
  if (random.from(0, 1) == 0) return nullptr;
  Plane weights(frame);
  for (float& weight : weights.samples) weight = std::exp2(float(random.from(-8, 8)) / 4);
  return std::make_shared<const Plane>(std::move(weights));
}

/// A frame before and after an edit, and their maps from scratch.
struct Update {
  Update(RandomImages& random, MetricKind kind, int width, int height)
      : reference(random.gradient(width, height)),
        before(random.from(0, 1) == 0 ? reference : random.edited(reference)),
        test(before),
        changed(random.part_of(reference.window())),
        metric(make_metric(kind, reference, some_weights(random, reference.window()))),
        map(metric->map(before)) {
    const Window inside = changed.clipped(reference.window());
    // A few scattered pixels, and in some frames a whole rectangle, of which some go back to the
    // reference.
    for (int i = random.from(0, 6); i > 0 && !inside.empty(); --i) {
      const int x = random.from(inside.x0, inside.x1 - 1),
                y = random.from(inside.y0, inside.y1 - 1);
      *test.at(x, y, random.from(0, 2)) ^= std::uint8_t(1 << random.from(0, 7));
    }
    if (random.from(0, 2) == 0)
      for (int y = inside.y0; y < inside.y1; ++y)
        for (int x = inside.x0; x < inside.x1; ++x) test.set_pixel(x, y, reference.pixel(x, y));
    whole = metric->map(test);
    rise = sum(whole, whole.window()) - sum(map, map.window());
  }

  Window around(int by) const { return changed.grown(by).clipped(reference.window()); }

  Image reference, before, test;
  Window changed;
  std::unique_ptr<Metric> metric;
  Plane map, whole;
  double rise = 0;
};

TEST(Metric, an_updated_map_holds_the_bits_of_a_new_one) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    RandomImages random(seed);
    const MetricKind kind = all_kinds[seed % 2];
    // Some frames hold more than one tile along both axes.
    Update update(random, kind, random.from(1, seed % 9 == 0 ? 1700 : 90), random.from(1, 150));
    const double change =
        update.metric->update_map(update.before, update.test, update.changed, update.map);
    EXPECT_NEAR(change, update.rise, 1e-9);
    expect_equal_bits(update.map, update.whole);
  }
}

TEST(Metric, a_map_is_updated_from_parts_of_the_frame) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    RandomImages random(seed);
    Update update(random, all_kinds[seed % 2], random.from(1, 90), random.from(1, 90));
    const int reach = update.metric->reach();
    const Image before = part(update.before, update.around(0));
    const Image test = part(update.test, update.around(2 * reach));
    Plane map = part(update.map, update.around(reach));
    const double change = update.metric->update_map(before, test, update.changed, map);
    EXPECT_NEAR(change, update.rise, 1e-9);
    expect_equal_bits(map, part(update.whole, update.around(reach)));
  }
}

TEST(Metric, an_update_gives_up_beyond_its_limit_only) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    RandomImages random(seed);
    Update update(random, all_kinds[seed % 2], random.from(30, 90), random.from(30, 300));
    const auto change_within = [&](double limit, Plane map) {
      return update.metric->update_map(update.before, update.test, update.changed, map, limit);
    };
    const double rise = change_within(std::numeric_limits<double>::infinity(), update.map);
    EXPECT_EQ(change_within(rise, update.map), rise);
    EXPECT_EQ(change_within(rise + 1e-6, update.map), rise);
    EXPECT_GT(change_within(rise - 1e-6, update.map), rise - 1e-6);
  }
}

TEST(Metric, an_update_on_all_threads_finds_the_same_also_where_it_gives_up) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    RandomImages random(seed);
    const Update update(random, all_kinds[seed % 2], random.from(30, 90), random.from(30, 600));
    for (const double share : {0.1, 0.5, 0.9, 2.0}) {
      const double limit = share * update.rise;
      Plane alone = update.map;
      const double change =
          update.metric->update_map(update.before, update.test, update.changed, alone, limit);
      for (const int threads : {1, 2, 3, 7}) {
        const ThreadLimit of(threads);
        Plane map = update.map;
        EXPECT_EQ(update.metric->update_map_in_parallel(update.before, update.test, update.changed,
                                                        map, limit),
                  change);
        if (share > 1) expect_equal_bits(map, alone);
      }
    }
  }
}

TEST(Metric, an_update_that_gives_up_leaves_out_the_rest) {
  RandomImages random(9);
  const Image reference = random.gradient(60, 400), test = random.noise(60, 400);
  for (const MetricKind kind : all_kinds) {
    const auto metric = make_metric(kind, reference);
    const Plane zero(60, 400);
    Plane map = zero;
    EXPECT_GT(metric->update_map(reference, test, reference.window(), map, 1), 1);
    expect_equal_bits(part(map, {0, 200, 60, 400}), part(zero, {0, 200, 60, 400}));
    EXPECT_GT(sum(map, map.window()), 1);
  }
}

TEST(Metric, an_update_looks_at_the_largest_part_first) {
  RandomImages random(12);
  const Image reference = random.gradient(90, 300), noise = random.noise(90, 300);
  for (const MetricKind kind : all_kinds) {
    const auto metric = make_metric(kind, reference);
    const Plane zero(90, 300);
    Image test = reference;
    test.set_pixel(5, 5, noise.pixel(5, 5));
    for (int y = 200; y < 300; ++y)
      for (int x = 0; x < 90; ++x) test.set_pixel(x, y, noise.pixel(x, y));
    Plane map = zero;
    EXPECT_GT(metric->update_map(reference, test, reference.window(), map, 1), 1);
    expect_equal_bits(part(map, {0, 0, 90, 100}), part(zero, {0, 0, 90, 100}));
  }
}

TEST(Metric, refuses_to_update_from_parts_that_are_too_small) {
  for (const MetricKind kind : all_kinds) {
    const Image frame(90, 80);
    const Window changed = {40, 30, 50, 45};
    const auto metric = make_metric(kind, frame);
    const int reach = metric->reach();
    const auto refused = [&](Window before, Window test, Window map_window) {
      Plane map(map_window);
      EXPECT_THROW(metric->update_map(Image(before), Image(test), changed, map),
                   std::invalid_argument);
    };
    const Window once = changed.grown(reach), twice = changed.grown(2 * reach);
    refused({40, 30, 50, 44}, twice, once);
    refused(changed, twice.grown(-1), once);
    refused(changed, twice, once.grown(-1));
  }
}

TEST(Metric, a_pixel_changes_the_map_as_far_as_its_reach_and_no_farther) {
  RandomImages random(5);
  constexpr int width = 60, height = 50;
  const Image reference = random.noise(width, height), before = random.noise(width, height);
  for (const MetricKind kind : all_kinds) {
    const auto metric = make_metric(kind, reference);
    const int reach = metric->reach();
    const Plane map = metric->map(before);
    for (const auto& [px, py] : {std::pair(30, 25), {0, 0}, {59, 20}, {3, 48}}) {
      Image after = before;
      for (int c = 0; c < 3; ++c) *after.at(px, py, c) = *after.at(px, py, c) < 128 ? 255 : 0;
      const Plane changed = metric->map(after);
      int farthest = 0;
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
          if (*changed.at(x, y) != *map.at(x, y))
            farthest = std::max(farthest, distance(x, y, px, py));
      EXPECT_EQ(farthest, reach) << title(kind) << ", pixel " << px << ", " << py;
    }
  }
}

TEST(Metric, the_number_of_threads_does_not_change_a_bit) {
  RandomImages random(6);
  const Image reference = random.gradient(150, 170), test = random.noise(150, 170);
  for (const MetricKind kind : all_kinds) {
    const auto map_with = [&](int threads) {
      const ThreadLimit limit(threads);
      return make_metric(kind, reference)->map(test);
    };
    const Plane one = map_with(1);
    expect_equal_bits(map_with(2), one);
    expect_equal_bits(map_with(5), one);
  }
}

TEST(Metric, every_set_of_instructions_gives_the_same_bits) {
#ifdef HWY_COMPILE_ONLY_STATIC
  GTEST_SKIP() << "this build has one set of instructions";
#endif
  RandomImages random(10);
  const std::pair<Image, Image> pairs[] = {{random.noise(83, 50), random.noise(83, 50)},
                                           {random.gradient(300, 90), random.gradient(300, 90)},
                                           {filled(30, 20, 0, 255, 0), filled(30, 20, 0, 0, 255)}};
  const auto maps = [&] {
    std::vector<Plane> result;
    for (const MetricKind kind : all_kinds)
      for (const auto& [reference, test] : pairs)
        result.push_back(make_metric(kind, reference)->map(test));
    return result;
  };
  const std::vector<Plane> best = maps();
  const std::vector<std::int64_t> targets = hwy::SupportedAndGeneratedTargets();
  ASSERT_GT(targets.size(), 1);
  for (const std::int64_t target : targets) {
    SCOPED_TRACE(hwy::TargetName(target));
    hwy::GetChosenTarget().Update(target);
    const std::vector<Plane> same = maps();
    for (std::size_t i = 0; i < best.size(); ++i) expect_equal_bits(same[i], best[i]);
  }
  hwy::GetChosenTarget().DeInit();
}

TEST(Metric, serves_several_threads_at_once) {
  RandomImages random(7);
  const Image reference = random.gradient(120, 90), test = random.noise(120, 90);
  for (const MetricKind kind : all_kinds) {
    const auto metric = make_metric(kind, reference);
    const Plane whole = metric->map(test);
    Plane tiled(120, 90);
    parallel_for(9 * 12, [&](std::size_t i) {
      const int x = int(i % 12) * 10, y = int(i / 12) * 10;
      metric->fill_map(test, {x, y, x + 10, y + 10}, tiled);
    });
    expect_equal_bits(tiled, whole);
  }
}

TEST(Metric, refuses_images_of_another_size) {
  for (const MetricKind kind : all_kinds) {
    const auto metric = make_metric(kind, Image(8, 6));
    Plane map(8, 6), other_map(6, 8);
    EXPECT_THROW(metric->fill_map(Image(6, 8), {0, 0, 6, 6}, map), std::invalid_argument);
    EXPECT_THROW(metric->fill_map(Image(8, 6), {0, 0, 6, 6}, other_map), std::invalid_argument);
  }
}

TEST(Metric, accepts_an_image_without_pixels) {
  for (const MetricKind kind : all_kinds) {
    EXPECT_EQ(mean(make_metric(kind, Image())->map(Image())), 0) << title(kind);
  }
}

// A running sum in float is off by far more than this on so many pixels.
TEST(Metric, mean_is_summed_in_double) {
  const Plane map(2000, 1500, 0.1F);
  EXPECT_NEAR(mean(map), double(0.1F), 1e-12);
}

// Pairs measured with the published programs. Their FLIP adds in float, which alone moves the
// most contrasted pairs by 9e-6.
TEST(Metric, agrees_with_the_published_programs) {
  const std::filesystem::path folder = std::filesystem::path(GRADMESH_SHARED_DIR) / "golden";
  std::ifstream list(folder / "metrics.json");
  if (!list) GTEST_SKIP() << "There is no " << folder / "metrics.json";
  const auto pairs = nlohmann::json::parse(list);
  ASSERT_FALSE(pairs.empty());
  for (const auto& pair : pairs) {
    SCOPED_TRACE(pair.at("a"));
    const Image a = read_image(folder / pair.at("a")), b = read_image(folder / pair.at("b"));
    EXPECT_NEAR(mean(make_metric(MetricKind::flip, a)->map(b)), double(pair.at("flip_srgb")), 1e-5);
    EXPECT_NEAR(mean(make_metric(MetricKind::ssim, a)->map(b)),
                1 - double(pair.at("ssim_romigrou")), 1e-7);
  }
}

}  // namespace
}  // namespace gradmesh
