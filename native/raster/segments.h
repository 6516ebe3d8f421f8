#pragma once

#include <array>

#include "raster/outlines.h"

namespace gradmesh {

// How the parameters of the pixels inside a traced outline are found: exactly at knots along each
// row, and by interpolation between the knots where that is near enough. Shared by invert.cpp and
// by the shader that does the same (device/shaders/shade.glsl).

/// Largest number of pixels from a knot to the next.
constexpr int most_length = 8;
/// How far knots may be from the surface, in pixels, and their slopes from the slopes of the
/// surface, in pixels for each pixel. In the middle of a segment an error of the slopes moves the
/// pixel by that error times a quarter of the segment's length.
constexpr float knot_error = 0.01F, slope_error = 1.0F / 256;
/// The part of the tenth of a pixel that knots and slopes leave to the cubics between knots.
constexpr float interpolation_error = 0.08F;
static_assert(knot_error + slope_error * most_length / 4 + interpolation_error < 0.1F);
/// Most steps of Newton's method at a knot, before it begins anew from the nearest of `start_cells`
/// + 1 points of the surface along each parameter, and most steps at a pixel.
constexpr int most_knot_steps = 6, most_polish_steps = 4, start_cells = 8;

/// Weights of value, next value, slope and next slope at each pixel of a segment, followed by a
/// vector's length of zeros.
using InterpolationBasis = std::array<std::array<float, 2 * std::size_t(most_length)>, 4>;
/// The bases for each length of a segment.
using InterpolationBases = std::array<InterpolationBasis, most_length + 1>;

constexpr InterpolationBases make_bases(bool cubic) {
  InterpolationBases bases = {};
  bases[0][0][0] = 1;
  for (int length = 1; length <= most_length; ++length)
    for (int i = 0; i <= length && i < most_length; ++i) {
      const double t = double(i) / length, s = 1 - t;
      bases[length][0][i] = float(cubic ? s * s * (1 + 2 * t) : s);
      bases[length][1][i] = float(cubic ? t * t * (1 + 2 * s) : t);
      bases[length][2][i] = float(cubic ? t * s * s * length : 0);
      bases[length][3][i] = float(cubic ? -t * t * s * length : 0);
    }
  return bases;
}

inline constexpr InterpolationBases hermite_bases = make_bases(true),
                                    linear_bases = make_bases(false);

}  // namespace gradmesh
