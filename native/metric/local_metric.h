#pragma once

#include <functional>
#include <utility>

#include "metric/metric.h"

namespace gradmesh {

/// A metric whose value at a pixel depends only on the pixels within `reach` of it, and is 0 where
/// none of these differs from the reference. It scores only the pixels near a difference, in tiles.
class LocalMetric : public Metric {
 public:
  void fill_map(const Image& test, Window window, Plane& map) const final;
  double update_map(const Image& before, const Image& test, Window changed, Plane& map,
                    double limit) const final;
  const Image& reference() const final { return reference_; }
  int reach() const final { return reach_; }

 protected:
  LocalMetric(Image reference, int reach) : reference_(std::move(reference)), reach_(reach) {}

  /// Writes the distances of the pixels of `tile`, which is not empty and lies inside the frame.
  /// `test` covers all pixels of the frame within the reach of the tile.
  virtual void score(const Image& test, Window tile, Plane& map) const = 0;

 private:
  Window around(Window window, int by) const {
    return window.grown(by).clipped(reference_.window());
  }
  void score_near_differences(const Image& test, Window window, Plane& map) const;

  Image reference_;
  int reach_;
};

/// Calls `body(strip)` in parallel for windows that share the rows of `window` between them, few
/// enough in each for the filtered rows to stay in the cache.
void for_each_strip(Window window, const std::function<void(Window)>& body);

}  // namespace gradmesh
