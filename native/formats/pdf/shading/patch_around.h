#pragma once

#include <array>
#include <cstddef>
#include <glm/vec2.hpp>

namespace gradmesh {

/// A bicubic patch as PDF lists it: the Bezier control points around it, then the inner ones, and
/// the colours of its corners (ISO 32000-1, 8.7.4.5.7 and 8.7.4.5.8). Side k has the outer points
/// from 3 k on, of which the first is corner k; inner point k is the one beside corner k.
template <class Color>
struct PatchAround {
  static constexpr std::size_t outer_count = 12;

  std::array<glm::dvec2, outer_count> outer{};
  std::array<glm::dvec2, 4> inner{};
  std::array<Color, 4> colors{};

  bool operator==(const PatchAround&) const = default;

  /// Returns point n, 0 to 3, of a side.
  glm::dvec2 side_point(std::size_t side, std::size_t n) const {
    return outer[(3 * side + n) % outer_count];
  }

  /// Returns the same surface, listed from corner `first` on.
  PatchAround turned(std::size_t first) const {
    PatchAround patch;
    for (std::size_t n = 0; n < outer_count; ++n)
      patch.outer[n] = outer[(3 * first + n) % outer_count];
    for (std::size_t k = 0; k < 4; ++k) {
      patch.inner[k] = inner[(first + k) % 4];
      patch.colors[k] = colors[(first + k) % 4];
    }
    return patch;
  }

  /// Returns the same surface, listed from the same corner the other way around.
  PatchAround mirrored() const {
    PatchAround patch;
    for (std::size_t n = 0; n < outer_count; ++n)
      patch.outer[n] = outer[(outer_count - n) % outer_count];
    for (std::size_t k = 0; k < 4; ++k) {
      patch.inner[k] = inner[(4 - k) % 4];
      patch.colors[k] = colors[(4 - k) % 4];
    }
    return patch;
  }

  /// Returns the control points p(i, j): side 0 runs along j at i = 0, side 3 along i at j = 0.
  std::array<std::array<glm::dvec2, 4>, 4> net() const {
    return {{{outer[0], outer[1], outer[2], outer[3]},
             {outer[11], inner[0], inner[1], outer[4]},
             {outer[10], inner[3], inner[2], outer[5]},
             {outer[9], outer[8], outer[7], outer[6]}}};
  }
  void set_net(const std::array<std::array<glm::dvec2, 4>, 4>& p) {
    outer = {p[0][0], p[0][1], p[0][2], p[0][3], p[1][3], p[2][3],
             p[3][3], p[3][2], p[3][1], p[3][0], p[2][0], p[1][0]};
    inner = {p[1][1], p[1][2], p[2][2], p[2][1]};
  }
};

/// Returns the bilinear patch with these corners and their colours: its sides are straight.
template <class Color>
PatchAround<Color> straight_patch(const std::array<glm::dvec2, 4>& corners,
                                  const std::array<Color, 4>& colors) {
  PatchAround<Color> patch;
  patch.colors = colors;
  for (std::size_t k = 0; k < 4; ++k) {
    const glm::dvec2 from = corners[k], to = corners[(k + 1) % 4];
    for (std::size_t n = 0; n < 3; ++n) patch.outer[3 * k + n] = from + double(n) / 3 * (to - from);
    // The inner point beside a corner is where the sides' thirds meet.
    patch.inner[k] =
        (4.0 * from + 2.0 * to + corners[(k + 2) % 4] + 2.0 * corners[(k + 3) % 4]) / 9.0;
  }
  return patch;
}

}  // namespace gradmesh
