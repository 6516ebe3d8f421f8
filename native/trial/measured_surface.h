#pragma once

#include <limits>
#include <vector>

#include "base/image.h"
#include "geom/patch.h"
#include "reference/reference.h"
#include "trial/local_bound.h"

namespace gradmesh {

/// The error of a mesh in the whole frame.
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
  /// Returns the map of the errors of details; without pixels where they are not looked at.
  const Plane& details() const { return details_; }
  /// Returns the metric's map of the whole frame.
  const Plane& map() const { return map_; }

 private:
  void find_errors(const LocalBound* bound);
  void find_detail();
  Window differs_from(const MeasuredSurface& near, const Frame& frame) const;

  bool masks_opacity_;
  /// The patches in the order in which they are painted; none where a patch is not painted by what
  /// it is alone: its colours follow its neighbours, or its sides have T-junctions.
  std::vector<Patch> patches_;
  Image image_;
  Plane map_;
  /// As of details().
  Plane details_;
  double sum_ = 0;
  FrameError error_;
};

}  // namespace gradmesh
