#pragma once

#include <algorithm>
#include <array>
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
  /// Returns the smallest window that holds both; an empty one adds nothing.
  Window united(const Window& o) const {
    if (empty()) return o;
    if (o.empty()) return *this;
    return {std::min(x0, o.x0), std::min(y0, o.y0), std::max(x1, o.x1), std::max(y1, o.y1)};
  }
};

/// Samples of the pixels of a window: one plane after another, one for each channel, each in rows
/// from top to bottom. Pixels keep the coordinates of the frame, of which the window may be a part.
template <class Sample, int Channels>
struct Raster {
  int x0 = 0, y0 = 0, width = 0, height = 0;
  std::vector<Sample> samples;

  Raster() = default;
  Raster(int w, int h, Sample fill = Sample{}) : Raster(Window{0, 0, w, h}, fill) {}
  explicit Raster(Window window, Sample fill = Sample{})
      : x0(window.x0),
        y0(window.y0),
        width(window.width()),
        height(window.height()),
        samples(pixels() * Channels, fill) {}

  /// Moves the raster to another window, after which the samples may have any values. Takes new
  /// memory only where the window is larger than all before.
  void reset(Window to) {
    x0 = to.x0, y0 = to.y0, width = to.width(), height = to.height();
    samples.resize(pixels() * Channels);
  }

  /// Returns a pointer to the sample at (x, y) in frame coordinates; those to its right follow.
  Sample* at(int x, int y, int channel = 0) { return samples.data() + offset(x, y, channel); }
  const Sample* at(int x, int y, int channel = 0) const {
    return samples.data() + offset(x, y, channel);
  }
  std::array<Sample, Channels> pixel(int x, int y) const {
    std::array<Sample, Channels> result;
    for (int c = 0; c < Channels; ++c) result[c] = *at(x, y, c);
    return result;
  }
  void set_pixel(int x, int y, const std::array<Sample, Channels>& to) {
    for (int c = 0; c < Channels; ++c) *at(x, y, c) = to[c];
  }

  Window window() const { return {x0, y0, x0 + width, y0 + height}; }
  std::size_t pixels() const { return std::size_t(width) * std::size_t(height); }
  bool operator==(const Raster&) const = default;

 private:
  std::size_t offset(int x, int y, int channel) const {
    return channel * pixels() + std::size_t(y - y0) * width + std::size_t(x - x0);
  }
};

/// Gives all samples of `window`, which lies inside the raster's window, the value `value`.
template <class Sample, int Channels>
void fill(Raster<Sample, Channels>& raster, Window window, Sample value) {
  for (int c = 0; c < Channels; ++c)
    for (int y = window.y0; y < window.y1; ++y)
      std::fill_n(raster.at(window.x0, y, c), window.width(), value);
}

/// Copies the samples of a window that lies in both rasters.
template <class Sample, int Channels>
void copy(const Raster<Sample, Channels>& from, Window window, Raster<Sample, Channels>& to) {
  for (int c = 0; c < Channels; ++c)
    for (int y = window.y0; y < window.y1; ++y)
      std::copy_n(from.at(window.x0, y, c), window.width(), to.at(window.x0, y, c));
}

/// An opaque image in 8-bit sRGB.
using Image = Raster<std::uint8_t, 3>;
/// An image in 8-bit sRGB with opacities, by which the colours are not multiplied.
using RgbaImage = Raster<std::uint8_t, 4>;

/// Returns the samples as r, g, b, r, g, b, ..., as files and NumPy hold an image.
template <int Channels>
std::vector<std::uint8_t> interleaved(const Raster<std::uint8_t, Channels>& image) {
  std::vector<std::uint8_t> bytes(image.samples.size());
  for (std::size_t i = 0; i < image.pixels(); ++i)
    for (std::size_t c = 0; c < Channels; ++c)
      bytes[Channels * i + c] = image.samples[c * image.pixels() + i];
  return bytes;
}

/// One float per pixel, such as a metric's error map.
using Plane = Raster<float, 1>;

}  // namespace gradmesh
