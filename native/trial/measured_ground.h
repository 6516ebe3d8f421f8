#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <mutex>

#include "base/image.h"
#include "metric/block_maxima.h"
#include "metric/metric.h"
#include "raster/frame.h"
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

/// How a surface on one ground is measured.
struct Measures {
  Frame frame;
  const Metric& metric;
  /// That of the local error; null for none.
  const LocalBound* bound = nullptr;
  /// Where details are looked at; null if they are not.
  const Raster<std::uint8_t, 1>* away_from_outline = nullptr;
};

/// A surface on one ground, painted and measured in the whole frame. Of one that is measured near
/// another only the part that differs is painted, measured and kept until the whole is asked for:
/// most of those that are tried are not taken.
class MeasuredGround {
 public:
  /// The picture and the maps of the whole frame, or of parts of it.
  struct Maps {
    Image image;
    /// The metric's map.
    Plane map;
    /// The errors of details; without pixels where they are not looked at.
    Plane details;
    /// These of the whole frame: the sum of the map, and by blocks the largest local mean, whose
    /// place is the first pixel of its window, and the largest error of a detail.
    double sum = 0;
    BlockMaxima local_means = {}, largest_details = {};
  };

  /// Paints and measures the whole.
  MeasuredGround(const Mesh& surface, const Measures& by);
  /// Paints and measures what has changed since `near`, at most the pixels of `changed`. Once the
  /// mean is certain to be above `limit` it is not worked out further: it is some number above
  /// `limit` then, the local error counts as beyond its bound, and there is no whole.
  MeasuredGround(const MeasuredGround& near, const Mesh& surface, Window changed,
                 const Measures& by, double limit);

  const FrameError& error() const { return error_; }
  /// Returns the maps of the whole frame, which are put together at the first call. May be called
  /// concurrently.
  const Maps& whole() const { return *shared_whole(); }

 private:
  const std::shared_ptr<const Maps>& shared_whole() const;
  void find_errors(const Measures& by);

  FrameError error_;
  /// The parts of the maps that differ from those of `near_`, with what is around them; the whole
  /// if that is null.
  mutable std::shared_ptr<const Maps> maps_, near_;
  mutable std::once_flag is_whole_;
};

}  // namespace gradmesh
