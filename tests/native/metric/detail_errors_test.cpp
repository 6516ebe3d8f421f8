// The means of errors in small windows (metric/detail_errors.h).
#include "metric/detail_errors.h"

#include <gtest/gtest.h>

#include <random>

namespace gradmesh {
namespace {

constexpr int across = 23, down = 17;

struct Maps {
  Plane errors{across, down};
  Raster<std::uint8_t, 1> counts{across, down, 1};
};

Maps random_maps(std::mt19937& random) {
  Maps maps;
  std::uniform_real_distribution<float> unit(0, 1);
  for (float& error : maps.errors.samples) error = unit(random);
  for (std::uint8_t& counts : maps.counts.samples) counts = unit(random) < 0.7F;
  return maps;
}

/// By the definition.
double naive_mean(const Maps& maps, int x, int y) {
  double sum = 0;
  for (int v = y - 2; v < y + 2; ++v)
    for (int u = x - 2; u < x + 2; ++u)
      if (u >= 0 && v >= 0 && u < across && v < down && *maps.counts.at(u, v))
        sum += *maps.errors.at(u, v);
  return sum / 16;
}

TEST(DetailErrors, are_the_means_of_what_counts) {
  std::mt19937 random(1);
  const Maps maps = random_maps(random);
  Plane means(across, down);
  update_detail_errors(maps.errors, maps.counts, maps.errors.window(), means);
  for (int y = 0; y < down; ++y)
    for (int x = 0; x < across; ++x)
      EXPECT_NEAR(*means.at(x, y), naive_mean(maps, x, y), 1e-6) << x << ' ' << y;
}

TEST(DetailErrors, an_update_of_what_changed_is_that_of_all) {
  std::mt19937 random(2);
  Maps maps = random_maps(random);
  Plane updated(across, down), anew(across, down);
  update_detail_errors(maps.errors, maps.counts, maps.errors.window(), updated);
  for (int round = 0; round < 50; ++round) {
    std::uniform_int_distribution<int> x(0, across), y(0, down);
    const int xs[] = {x(random), x(random)}, ys[] = {y(random), y(random)};
    const Window changed{std::min(xs[0], xs[1]), std::min(ys[0], ys[1]), std::max(xs[0], xs[1]),
                         std::max(ys[0], ys[1])};
    for (int v = changed.y0; v < changed.y1; ++v)
      for (int u = changed.x0; u < changed.x1; ++u) *maps.errors.at(u, v) = float(u * v % 7);
    update_detail_errors(maps.errors, maps.counts, changed, updated);
    update_detail_errors(maps.errors, maps.counts, maps.errors.window(), anew);
    EXPECT_EQ(updated, anew);
  }
}

}  // namespace
}  // namespace gradmesh
