#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "base/image.h"
#include "geom/patch.h"
#include "reference/reference.h"
#include "trial/local_bound.h"
#include "trial/measured_ground.h"

namespace gradmesh {

/// A surface as it will be written, painted and measured in the whole frame of a reference.
class MeasuredSurface {
 public:
  /// Paints and measures the whole. The local error keeps to `bound`, or to none if that is null.
  /// Details are looked at if `measures_details` is true.
  MeasuredSurface(const Reference& reference, const Mesh& surface, bool masks_opacity,
                  const LocalBound* bound, bool measures_details = false);

  /// Paints and measures what differs from `near`, which was measured against the same reference
  /// with the same bound, and whose details were looked at or not. Once the mean is certain to be
  /// above `limit` it is not worked out further: it is some number above `limit` then, and the
  /// local error counts as beyond its bound.
  MeasuredSurface(const MeasuredSurface& near, const Reference& reference, const Mesh& surface,
                  const LocalBound* bound, double limit = std::numeric_limits<double>::infinity());

  const FrameError& error() const { return error_; }
  /// Returns the map of the errors of details, of the ground with the largest; without pixels where
  /// they are not looked at.
  const Plane& details() const;
  /// Returns the metric's map of the whole frame on white.
  const Plane& map() const { return on_white_->whole().map; }

 private:
  void find_error();
  Window differs_from(const MeasuredSurface& near, const Frame& frame) const;

  const bool masks_opacity_;
  /// The patches in the order in which they are painted; none where a patch is not painted by what
  /// it is alone: its colours follow its neighbours, or its sides have T-junctions.
  std::vector<Patch> patches_;
  /// Always there once this is made.
  std::optional<MeasuredGround> on_white_;
  /// Only where the original is translucent, and not where on white the mean is above the limit.
  std::optional<MeasuredGround> on_black_;
  FrameError error_;
};

}  // namespace gradmesh
