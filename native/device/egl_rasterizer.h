#pragma once

#include <memory>

#include "device/device.h"
#include "raster/rasterizer.h"

namespace gradmesh {

/// Returns a rasterizer that paints on a device what the software rasterizer paints: the same
/// pixels, and the same colours but for roundings. The parameters of patches that may fold are
/// found by the processor. paint() may throw DeviceError.
std::unique_ptr<Rasterizer> make_egl_rasterizer(std::shared_ptr<Device> device);

}  // namespace gradmesh
