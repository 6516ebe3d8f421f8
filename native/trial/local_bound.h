#pragma once

#include <functional>

#include "base/image.h"

namespace gradmesh {

/// The largest mean that the metric's map may have in any window of 32 x 32 pixels
/// (metric/local_mean.h), so that a detail is not given up for calm areas elsewhere.
class LocalBound {
 public:
  /// Bounds every window by `largest`. A window that is above it in `start`, the map of the whole
  /// frame before anything is merged, may keep its mean of `start`.
  LocalBound(double largest, const Plane& start);
  /// Returns a bound by which the mean of each window may be so much larger than in `start`, that
  /// of a mesh that differs from its original by what nobody minds.
  static LocalBound beyond(double more, const Plane& start);

  /// Returns true if all windows inside `map`, a part of the frame, keep to the bound.
  bool holds(const Plane& map) const;
  /// Returns the same of a map whose largest_local_mean is known. The map is asked for only where
  /// that is not enough.
  bool holds(double largest, const std::function<const Plane&()>& map) const;

 private:
  explicit LocalBound(double largest) : largest_(largest) {}

  double largest_;
  /// The bound of each window by its top left pixel; empty if all are `largest_`.
  Raster<double, 1> allowed_;
};

}  // namespace gradmesh
