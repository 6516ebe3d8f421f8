#pragma once

#include "metric/local_metric.h"

namespace gradmesh {

/// 1 - SSIM of Wang et al. 2004 ("Image quality assessment: from error visibility to structural
/// similarity") on bytes, mean of the three channels: 11x11 Gaussian of sigma 1.5, population
/// covariance, K1 = 0.01, K2 = 0.03. 0 to 2; above 1 only where the images are anti-correlated.
class Ssim final : public LocalMetric {
 public:
  explicit Ssim(Image reference);

 private:
  void score(const Image& test, Window tile, Plane& map) const override;

  /// Gaussian mean less `byte_centre`, and variance.
  /// Three channels side by side in each pixel.
  Plane mean_, variance_;
};

}  // namespace gradmesh
