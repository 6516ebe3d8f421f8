#pragma once

#include <memory>
#include <vector>

#include "base/image.h"
#include "mesh/mesh.h"
#include "metric/metric.h"
#include "raster/rasterizer.h"

namespace gradmesh {

/// How a painted mesh differs from a picture, both over white.
struct PictureErrors {
  /// The root of the mean square and the mean of the differences, in levels, 0..255.
  double rmse = 0, mean = 0;
  /// The mean of FLIP, 0..1, and the largest one in any window of 32 x 32 pixels
  /// (metric/local_mean.h), where pixels that do not count have no error.
  double flip = 0, local_flip = 0;
};

/// A picture that meshes are compared with, as Inkscape paints them.
class PictureComparison {
 public:
  /// `to_pixels` maps meshes to the picture's pixels, of which one is `scale` pixels of the
  /// document where that is painted at its own size. `counted` has a number other than 0 for each
  /// pixel that counts, row by row; empty if all do.
  PictureComparison(const RgbaImage& picture, const Affine& to_pixels, double scale,
                    std::vector<float> counted = {});

  /// Returns how many pixels count.
  std::size_t pixels() const { return pixels_; }
  const Frame& frame() const { return frame_; }
  double flip(const Mesh& mesh) const;
  PictureErrors errors(const Mesh& mesh) const;
  /// Returns the painted mesh with the picture's own pixels where none counts.
  Image painted(const Mesh& mesh) const;

 private:
  /// Returns the errors of all pixels, 0 where none counts.
  Plane flip_map(const Image& painted) const;
  double mean_of_counted(const Plane& map) const;
  bool counts(std::size_t pixel) const { return counted_.empty() || counted_[pixel] != 0; }

  const std::vector<float> counted_;
  const std::size_t pixels_;
  const std::unique_ptr<Metric> metric_;
  const std::unique_ptr<Rasterizer> painter_;
  Frame frame_;
};

}  // namespace gradmesh
