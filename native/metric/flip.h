#pragma once

#include "metric/appearance.h"
#include "metric/metric.h"

namespace gradmesh {

/// FLIP for low dynamic range images (Andersson et al. 2020), with its default of 67.02 pixels
/// per degree. Symmetric in its two images.
class Flip final : public Metric {
 public:
  Flip(Image reference, Weights weights);

 private:
  void score(const Image& test, Window tile, Plane& map) const override;

  PaddedRows<float> appearance_;  ///< The reference's (appearance_row).
};

}  // namespace gradmesh
