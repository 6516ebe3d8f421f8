#pragma once

#include <array>
#include <cstdint>
#include <glm/vec4.hpp>
#include <vector>

#include "base/image.h"

namespace gradmesh {

/// What a mesh is to look like a picture: of each pixel, row by row, the colour and the opacity
/// that the mesh is to have there, in levels, 0..255.
struct TargetPicture {
  int width = 0, height = 0;
  std::vector<glm::vec4> pixels;
  /// How many times each pixel counts; empty if all count once.
  std::vector<float> weights = {};
  bool is_opaque = true;
  /// Where in a pixel, in both directions, the mesh is to have its colour, 0..1.
  double point = 0.5;

  const glm::vec4& at(int x, int y) const {
    return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)];
  }
  double weight(int x, int y) const {
    if (weights.empty()) return 1;
    return double(weights[std::size_t(y) * std::size_t(width) + std::size_t(x)]);
  }
  /// Returns how many pixels count, each by its weight.
  double counted() const;
  std::size_t samples() const { return pixels.size(); }
};

/// Returns where in its pixels a target is to have its colours, of which a pixel is `scale` pixels
/// of the document where that is painted at its own size, or enlarged so that a pixel is one where
/// the scale is below 1.
///
/// Cairo, by which Inkscape paints a mesh gradient, colours a pixel by the last of the samples that
/// fall into it, a quarter of a pixel beyond the middle in the mean (raster/cairo_like.cpp). A mesh
/// that has the picture's colours there looks like the picture where a hard edge would otherwise be
/// off by that much.
double point_of_pixels(double scale);

/// Returns the colour and opacity, in levels, that a mesh is to have where a pixel is to be of this
/// colour. Cairo mixes in 16 bits and keeps the upper 8: it paints a level of x as 257/256 x,
/// rounded down, which in the mean is half a level too dark in black and too bright in white.
glm::vec4 level_for(const std::array<std::uint8_t, 4>& pixel);

/// Returns the target of a whole picture of which a pixel is `scale` pixels of the document.
TargetPicture target_of(const RgbaImage& picture, double scale);

/// Returns the target with half as many pixels each way, each the mean of those it covers: pixels
/// count by their weights, and colours by their opacities too.
TargetPicture halved(const TargetPicture& target);

}  // namespace gradmesh
