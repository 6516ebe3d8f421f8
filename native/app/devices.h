#pragma once

#include <memory>
#include <string>

#include "base/message.h"
#include "device/device.h"
#include "mesh/mesh.h"
#include "metric/metric.h"
#include "raster/frame.h"

namespace gradmesh {

/// Where the errors of many edits are found.
enum class Renderer {
  automatic,  ///< on a graphics processor where there is one and it is faster for the mesh
  software,   ///< on the cores
  egl,        ///< on the first device that EGL offers, even a program in its place
};

/// Names as in options: "auto", "software", "egl".
const char* name(Renderer renderer);
/// Throws std::invalid_argument with the names there are.
Renderer renderer_named(const std::string& name);

/// Why there is none where `egl` was asked for.
inline constexpr const char* no_device =
    "EGL offers no device that can be used (gradmesh devices tells why)";

/// The device that may be used, null for none. Opening one takes a tenth of a second.
std::shared_ptr<Device> open_device(Renderer renderer);

/// How long pricing takes, found by pricing two small meshes.
struct Speed {
  /// Seconds before the first pixel, and for each pixel (priced_pixels).
  double start = 0, per_pixel = 0;

  double seconds(double pixels) const { return start + per_pixel * pixels; }
};
struct Speeds {
  Speed software, device;
};

/// About how many pixels are painted and measured when the edges and regions of a mesh are priced.
double priced_pixels(const Mesh& mesh, const Frame& frame, MetricKind metric);

/// Measures both on so many threads (0: all cores); takes about a second. Throws DeviceError.
Speeds measure_speeds(const std::shared_ptr<Device>& device, int threads);
/// As measured when the device was first used with this version and as many threads, and kept in
/// the user's cache folder; what cannot be kept is measured again. Throws DeviceError.
Speeds known_speeds(const std::shared_ptr<Device>& device, int threads);

/// Which of both is expected to be faster, and why.
struct RendererChoice {
  bool takes_device = false;
  Message reason;
};
RendererChoice faster(const Speeds& speeds, double pixels);
/// What `auto` takes for a mesh, of software and this device; software where that fails.
RendererChoice choose_renderer(const std::shared_ptr<Device>& device, const Mesh& mesh,
                               const Frame& frame, MetricKind metric, int threads);

/// The device that `auto` takes for a mesh, null for software. None is started where pricing takes
/// less time than that.
std::shared_ptr<Device> automatic_device(const Mesh& mesh, const Frame& frame, MetricKind metric,
                                         int threads);

}  // namespace gradmesh
