#pragma once

#include <memory>
#include <span>
#include <vector>

#include "device/device.h"
#include "metric/metric.h"
#include "raster/edit_tile.h"

namespace gradmesh {

/// Measures many edits of one picture at once on a device: what the edits change is painted into
/// the tiles of an atlas and compared with the original there, and one number for each edit comes
/// back. Every call may throw DeviceError; the object is then of no further use.
class DeviceErrors {
 public:
  DeviceErrors(std::shared_ptr<Device> device, MetricKind metric, const Image& original,
               Frame frame);
  ~DeviceErrors();

  /// Sets the picture that the edits start from.
  void start(const Painting& painting);

  /// Begins to measure these edits and returns before that is done.
  void submit(std::span<const EditTile> edits);
  /// Waits for the edits submitted last. Returns for each of them by how much the sum of the
  /// metric's map over the frame rises.
  std::vector<double> rises();

  const DeviceInfo& device() const { return device_->info(); }

 private:
  struct Objects;
  std::shared_ptr<Device> device_;
  Frame frame_;
  std::unique_ptr<Objects> objects_;
};

}  // namespace gradmesh
