#pragma once

#include "base/image.h"

namespace gradmesh {

/// What the mean of the metric's map may be in any window of 32 x 32 pixels (metric/local_mean.h),
/// so that a detail is not given up for calm areas elsewhere.
class LocalBound {
 public:
  /// `largest` for every window. One that is above it in `start`, the map of the whole frame before
  /// anything is merged, may stay as it is there.
  LocalBound(double largest, const Plane& start);

  /// Whether all windows inside `map`, a part of the frame, keep to it.
  bool holds(const Plane& map) const;

 private:
  double largest_;
  /// For each window by its top left pixel, where they are not all `largest_`.
  Raster<double, 1> allowed_;
};

}  // namespace gradmesh
