#pragma once

#include <cmath>

#include "metric/taps.h"

namespace gradmesh {

/// The distance in pixels, along each axis, up to which a pixel changes SSIM's map.
inline constexpr int ssim_radius = 5;

/// Returns the Gaussian window of Wang et al. 2004: 11 x 11, sigma 1.5.
inline const Taps<float, ssim_radius>& ssim_taps() {
  static const auto taps = [] {
    constexpr double sigma = 1.5;
    const auto exact =
        sample_taps<ssim_radius>([](int k) { return std::exp(-k * k / (2 * sigma * sigma)); });
    return scaled<float>(exact, 1 / sum(exact));
  }();
  return taps;
}

}  // namespace gradmesh
