#pragma once

#include <memory>

#include "base/image.h"

namespace gradmesh {

enum class MetricKind { flip, ssim };

/// Distance of test images to one fixed reference image, per pixel; 0 where they are equal.
///
/// SSIM is Wang et al. 2004 as `1 - SSIM` (mean of the three channels), up to 2 where the images
/// are anti-correlated; FLIP is the LDR metric of Andersson et al. 2020, up to 1. Both treat a
/// pixel beyond the frame as the nearest one inside. Whatever depends on the reference alone is
/// computed once, by the constructor; the other members may be called concurrently.
class Metric {
 public:
  virtual ~Metric() = default;

  /// Writes the distance of every pixel in `window` into `map`, which has the size of the
  /// frame; other pixels of `map` stay as they are. The values are the same for every window
  /// that holds the pixel. Throws std::invalid_argument where the sizes differ.
  virtual void fill_map(const Image& test, Window window, Plane& map) const = 0;

  /// How many pixels away, along each axis, a changed pixel still changes the map.
  virtual int reach() const = 0;

  Plane map(const Image& test) const {
    Plane result(test.width, test.height);
    fill_map(test, test.window(), result);
    return result;
  }
};

/// Any size of reference will do, also one smaller than the filters.
std::unique_ptr<Metric> make_metric(MetricKind kind, Image reference);

/// Mean over all pixels, summed in double, row by row; 0 for a map without pixels.
double mean(const Plane& map);

}  // namespace gradmesh
