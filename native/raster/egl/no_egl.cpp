// What a build without EGL has in place of the rest of this folder: there are no devices.

#include "raster/egl/edit_errors.h"
#include "raster/egl/egl_rasterizer.h"

namespace gradmesh {

struct Device::Context {};
Device::~Device() = default;
std::vector<DeviceInfo> Device::list() { return {}; }
std::shared_ptr<Device> Device::open(bool) { return nullptr; }

struct EditErrors::Objects {};
EditErrors::EditErrors(std::shared_ptr<Device> device, MetricKind, const Image&, Frame frame)
    : device_(std::move(device)), frame_(std::move(frame)) {}
EditErrors::~EditErrors() = default;
void EditErrors::start(const Painting&) {}
void EditErrors::submit(std::span<const EditTile>) {}
std::vector<double> EditErrors::rises() { return {}; }

std::unique_ptr<Rasterizer> make_egl_rasterizer(std::shared_ptr<Device>) {
  return make_software_rasterizer();
}

}  // namespace gradmesh
