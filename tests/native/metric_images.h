#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>

#include "metric/metric.h"

namespace gradmesh::test {

inline constexpr MetricKind all_kinds[] = {MetricKind::flip, MetricKind::ssim};

inline const char* title(MetricKind kind) { return kind == MetricKind::flip ? "FLIP" : "SSIM"; }

inline Image filled(int width, int height, std::uint8_t r, std::uint8_t g, std::uint8_t b) {
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) image.set_pixel(x, y, {r, g, b});
  return image;
}

/// Images to measure, of numbers that a seed makes.
class RandomImages {
 public:
  explicit RandomImages(unsigned seed) : engine_(seed) {}

  /// From `low` to `high`, both included.
  int from(int low, int high) { return std::uniform_int_distribution(low, high)(engine_); }

  Image noise(int width, int height) {
    Image image(width, height);
    for (auto& sample : image.samples) sample = std::uint8_t(from(0, 255));
    return image;
  }

  /// A colour gradient, as the images that the metrics are made for.
  Image gradient(int width, int height) {
    const double u[3] = {from(-20, 20) / 9.0, from(-20, 20) / 9.0, from(-20, 20) / 9.0};
    const double v[3] = {from(-20, 20) / 9.0, from(-20, 20) / 9.0, from(-20, 20) / 9.0};
    Image image(width, height);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        for (int c = 0; c < 3; ++c)
          *image.at(x, y, c) = std::uint8_t(std::clamp(128 + u[c] * x + v[c] * y, 0.0, 255.0));
    return image;
  }

  /// The image with a rectangle of other colours.
  Image edited(Image image) {
    const Window window = part_of(image.window()).clipped(image.window());
    for (int y = window.y0; y < window.y1; ++y)
      for (int x = window.x0; x < window.x1; ++x)
        for (int c = 0; c < 3; ++c) *image.at(x, y, c) ^= std::uint8_t(from(1, 63));
    return image;
  }

  /// A window that may stick out of the frame.
  Window part_of(Window frame) {
    const int x = from(-3, frame.x1 - 1), y = from(-3, frame.y1 - 1);
    return {x, y, from(x + 1, frame.x1 + 3), from(y + 1, frame.y1 + 3)};
  }

 private:
  std::mt19937 engine_;
};

inline void expect_equal_bits(const Plane& a, const Plane& b) {
  ASSERT_EQ(a.window(), b.window());
  const Window window = a.window();
  for (int y = window.y0; y < window.y1; ++y)
    for (int x = window.x0; x < window.x1; ++x)
      ASSERT_EQ(*a.at(x, y), *b.at(x, y)) << x << ", " << y;
}

}  // namespace gradmesh::test
