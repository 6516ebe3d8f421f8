#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "base/image.h"
#include "geom/patch.h"
#include "reference/reference.h"
#include "trial/local_bound.h"

namespace gradmesh {

/// The error of a mesh in the whole frame. Small parts of one that is measured on black too
/// (Reference::metric_on_black) have the larger of their two errors. The mean is that on white:
/// bounded on black as well it left 218 instead of 169 handles of a bubble of which nobody saw a
/// change.
struct FrameError {
  double mean = 0;
  /// The largest mean in any window of 32 x 32 pixels (metric/local_mean.h).
  double local = 0;
  /// True if no window is above the bound that was asked for.
  bool keeps_local_bound = true;
  /// The largest mean in any window of 4 x 4 pixels away from the outline
  /// (metric/detail_errors.h); 0 where that is not asked for.
  double detail = 0;

  bool keeps_to(double epsilon) const { return mean <= epsilon && keeps_local_bound; }
};

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
  const Plane& map() const { return on_white_.map; }

 private:
  /// The surface on one ground.
  struct OnGround {
    Image image;
    Plane map;
    /// Without pixels where details are not looked at.
    Plane details;
    double sum = 0;
    FrameError error;

    /// Paints and measures the whole.
    OnGround(const Mesh& surface, const Frame& frame, const Metric& metric, const LocalBound* bound,
             const Raster<std::uint8_t, 1>* away_from_outline);
    /// Paints and measures what has changed since `near`.
    OnGround(const OnGround& near, const Mesh& surface, const Frame& frame, Window changed,
             const Metric& metric, const LocalBound* bound,
             const Raster<std::uint8_t, 1>& away_from_outline, double limit);

    void find_errors(const LocalBound* bound);
  };

  void find_error();
  Window differs_from(const MeasuredSurface& near, const Frame& frame) const;

  bool masks_opacity_;
  /// The patches in the order in which they are painted; none where a patch is not painted by what
  /// it is alone: its colours follow its neighbours, or its sides have T-junctions.
  std::vector<Patch> patches_;
  OnGround on_white_;
  /// Only where the original is translucent, and not where on white the mean is above the limit.
  std::optional<OnGround> on_black_;
  FrameError error_;
};

}  // namespace gradmesh
