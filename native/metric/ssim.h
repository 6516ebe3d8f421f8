#pragma once

#include <cmath>

#include "metric/metric.h"
#include "metric/padded_rows.h"
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

/// 1 - SSIM of Wang et al. 2004 ("Image quality assessment: from error visibility to structural
/// similarity") on bytes, mean of the three channels: 11x11 Gaussian of sigma 1.5, population
/// covariance, K1 = 0.01, K2 = 0.03. 0 to 2; above 1 only where the images are anti-correlated.
class Ssim final : public Metric {
 public:
  Ssim(Image reference, Weights weights);

 private:
  void score(const Image& test, Window tile, Plane& map) const override;

  /// Gaussian means less `byte_centre` of the reference's three channels, then their variances.
  PaddedRows<float> moments_;
};

}  // namespace gradmesh
