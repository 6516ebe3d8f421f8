#pragma once

#include <array>
#include <cstddef>
#include <glm/vec4.hpp>

#include "trace/pixels.h"
#include "trace/target_picture.h"

namespace gradmesh {

/// A patch with straight sides, in pixels of a target, and its colours in levels, by corners.
struct ColoredQuad {
  Quad places;
  std::array<glm::dvec4, 4> colors;
};

/// What is asked for of a patch: how far it is from the target, with what colours it would be
/// nearest, or also what its points change.
enum class Asked { squares, colors, all };

/// The sums over the pixels of a patch of which its equations consist (trace/equations.h). At each
/// pixel corner a counts by w_a, the corners' shares of a bilinear patch, and the differences from
/// the target are d. All that belongs to a channel counts by the channel's weight.
struct PatchSums {
  static constexpr std::size_t corners = 4, channels = 4, axes = 2;
  /// Pairs of corners a >= b, one after the other: 00, 10, 11, 20, ...
  static constexpr std::size_t pairs = 10;
  using Corners = std::array<double, corners>;
  using Pairs = std::array<double, pairs>;

  static std::size_t pair(std::size_t a, std::size_t b) {
    return a > b ? a * (a + 1) / 2 + b : b * (b + 1) / 2 + a;
  }

  /// d * d.
  std::array<double, channels> squares{};
  /// -w_a * d.
  std::array<Corners, channels> color_rhs{};
  /// w_a * w_b, of red, green and blue, which count alike, and of opacity.
  Pairs color{}, opacity{};
  /// w_a * d * slope, summed over channels, where a slope is how a colour changes along x and y.
  std::array<Corners, axes> place_rhs{};
  /// w_a * w_b * slope * slope, summed over channels: x by x, x by y, y by y.
  std::array<Pairs, 3> place{};
  /// -w_a * w_b * slope, by channel.
  std::array<std::array<Pairs, axes>, channels> both{};
};

/// Returns the sums of what is asked for; others stay 0, as those of opacity do where the target is
/// opaque. They are the same to the bit on all processors: of eight pixels in a row each is added
/// to a sum of its own.
PatchSums patch_sums(const ColoredQuad& patch, const TargetPicture& target, Asked asked);

}  // namespace gradmesh
