// What a build without EGL has in place of the rest of this folder: there are no devices.

#include "device/device_errors.h"
#include "device/egl_rasterizer.h"

namespace gradmesh {

struct Device::Context {};
Device::~Device() = default;
std::vector<DeviceInfo> Device::list() { return {}; }
std::shared_ptr<Device> Device::open(bool) { return nullptr; }

struct DeviceErrors::Objects {};
DeviceErrors::DeviceErrors(std::shared_ptr<Device> device, MetricKind, const Image&, Frame frame)
    : device_(std::move(device)), frame_(std::move(frame)) {}
DeviceErrors::~DeviceErrors() = default;
void DeviceErrors::start(const Painting&) {}
void DeviceErrors::submit(std::span<const EditTile>) {}
std::vector<double> DeviceErrors::rises() { return {}; }

std::unique_ptr<Rasterizer> make_egl_rasterizer(std::shared_ptr<Device>) {
  return make_software_rasterizer();
}

}  // namespace gradmesh
