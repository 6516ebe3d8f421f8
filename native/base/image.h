#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gradmesh {

/// Half-open rectangle of pixels: x0 <= x < x1, y0 <= y < y1.
struct Window {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

  int width() const { return std::max(0, x1 - x0); }
  int height() const { return std::max(0, y1 - y0); }
  bool empty() const { return x1 <= x0 || y1 <= y0; }
  bool operator==(const Window&) const = default;

  Window clipped(const Window& o) const {
    return {std::max(x0, o.x0), std::max(y0, o.y0), std::min(x1, o.x1), std::min(y1, o.y1)};
  }
  Window grown(int by) const { return {x0 - by, y0 - by, x1 + by, y1 + by}; }
  /// Smallest window that holds both; an empty one adds nothing.
  Window united(const Window& o) const {
    if (empty()) return o;
    if (o.empty()) return *this;
    return {std::min(x0, o.x0), std::min(y0, o.y0), std::max(x1, o.x1), std::max(y1, o.y1)};
  }
};

/// Rows of pixels from top to bottom, `Channels` interleaved samples each.
template <class Sample, int Channels>
struct Raster {
  int width = 0, height = 0;
  std::vector<Sample> samples;

  Raster() = default;
  Raster(int w, int h, Sample fill = Sample{})
      : width(w), height(h), samples(std::size_t(w) * std::size_t(h) * Channels, fill) {}

  Sample* at(int x, int y) { return samples.data() + (std::size_t(y) * width + x) * Channels; }
  const Sample* at(int x, int y) const {
    return samples.data() + (std::size_t(y) * width + x) * Channels;
  }
  Window window() const { return {0, 0, width, height}; }
  bool operator==(const Raster&) const = default;
};

/// 8-bit sRGB, opaque.
using Image = Raster<std::uint8_t, 3>;
/// One float per pixel, such as a metric's error map.
using Plane = Raster<float, 1>;

}  // namespace gradmesh
