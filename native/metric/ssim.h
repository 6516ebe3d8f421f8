#pragma once

#include "metric/local_metric.h"
#include "metric/padded_rows.h"

namespace gradmesh {

/// 1 - SSIM of Wang et al. 2004 ("Image quality assessment: from error visibility to structural
/// similarity") on bytes, mean of the three channels: 11x11 Gaussian of sigma 1.5, population
/// covariance, K1 = 0.01, K2 = 0.03. 0 to 2; above 1 only where the images are anti-correlated.
class Ssim final : public LocalMetric {
 public:
  explicit Ssim(Image reference);

 private:
  void score(const Image& test, Window tile, Plane& map) const override;

  /// Gaussian means less `byte_centre` of the reference's three channels, then their variances.
  PaddedRows<float> moments_;
};

}  // namespace gradmesh
