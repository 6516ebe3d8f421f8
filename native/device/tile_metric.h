#pragma once

#include <memory>

#include "device/tile_painter.h"
#include "metric/metric.h"

namespace gradmesh {

/// Measures SSIM or FLIP against one reference image by compute shaders, equal to
/// Metric::update_map to some parts in a million. All images stay on the device.
class TileMetric {
 public:
  TileMetric(const Device::Use& use, MetricKind kind, const Image& reference);

  /// Measures the whole picture, from which edits start.
  void start(const FrameImage& picture);
  /// Measures by how much the sum of the distances rises with each tile of the atlas, which
  /// `painter` has painted. The rises stay on the device until read_rises.
  void measure(const Atlas& atlas, const TilePainter& painter, const FrameImage& picture);
  void read_rises(std::span<float> rises) const { totals_.read(rises); }

  int reach() const { return reach_; }

 private:
  void run(const Program& program, const Buffer& tiles, int blocks, const FrameImage& picture,
           const Buffer& colors);
  /// Runs a pass over the whole frame.
  void run_whole(const Program& program, const FrameImage& picture);

  int reach_;
  const Program &distances_, &rises_, &total_;
  /// A table for the shader: the linear light of the levels, or the reference's colours.
  Buffer table_;
  Buffer whole_, reference_, map_, block_rises_, totals_;
};

}  // namespace gradmesh
