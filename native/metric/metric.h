#pragma once

#include <memory>

#include "base/image.h"

namespace gradmesh {

enum class MetricKind { flip, ssim };

/// Distance of test images to one fixed reference image, 0 (equal) to 1, per pixel.
///
/// SSIM is Wang et al. 2004 as `1 - SSIM` (mean of the three channels); FLIP is the LDR metric
/// of Andersson et al. 2020. Both treat a pixel beyond the frame as the nearest one inside.
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

std::unique_ptr<Metric> make_metric(MetricKind kind, Image reference);

/// Mean over all pixels, summed in double, row by row.
double mean(const Plane& map);

}  // namespace gradmesh
