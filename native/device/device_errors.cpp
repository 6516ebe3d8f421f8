#include "device/device_errors.h"

#include "device/tile_metric.h"
#include "device/use.h"

namespace gradmesh {

struct DeviceErrors::Objects {
  TilePainter painter;
  TileMetric metric;
  FrameImage picture;
  Atlas atlas;

  Objects(const Device::Use& use, MetricKind kind, const Image& original)
      : painter(use), metric(use, kind, original) {}
};

DeviceErrors::DeviceErrors(std::shared_ptr<Device> device, MetricKind metric, const Image& original,
                           Frame frame)
    : device_(std::move(device)), frame_(std::move(frame)) {
  const Device::Use use(*device_);
  objects_ = std::make_unique<Objects>(use, metric, original);
  use.check();
}

DeviceErrors::~DeviceErrors() { release_on(*device_, objects_); }

void DeviceErrors::start(const Painting& painting) {
  const Device::Use use(*device_);
  objects_->picture.set(frame_, painting);
  objects_->metric.start(objects_->picture);
  use.check();
}

void DeviceErrors::submit(std::span<const EditTile> edits) {
  const Device::Use use(*device_);
  Atlas& atlas = objects_->atlas;
  atlas.clear();
  for (const EditTile& edit : edits) {
    const Window measured =
        edit.window.empty() ? Window{}
                            : edit.window.grown(objects_->metric.reach()).clipped(frame_.window());
    atlas.add(edit, measured);
  }
  objects_->painter.paint(atlas, &objects_->picture);
  objects_->metric.measure(atlas, objects_->painter, objects_->picture);
  glFlush();
  use.check();
}

std::vector<double> DeviceErrors::rises() {
  const Device::Use use(*device_);
  std::vector<float> rises(objects_->atlas.tiles.size());
  objects_->metric.read_rises(rises);
  use.check();
  return {rises.begin(), rises.end()};
}

}  // namespace gradmesh
