#pragma once

#include <functional>
#include <memory>
#include <string>

#include "base/message.h"
#include "device/device.h"
#include "mesh/mesh.h"
#include "metric/metric.h"
#include "raster/frame.h"
#include "simplify/simplify.h"

namespace gradmesh {

/// Where the errors of many edits are found.
enum class Renderer {
  automatic,  ///< on a graphics processor where there is one and it is faster for the mesh
  software,   ///< on the cores
  egl,        ///< on the first device that EGL offers, even a program in its place
};

/// Returns the name as in options: "auto", "software", "egl".
const char* name(Renderer renderer);
/// Returns the renderer of that name. Throws std::invalid_argument with all names if there is none.
Renderer renderer_named(const std::string& name);

/// Message if there is no device, but `egl` was asked for.
inline constexpr const char* no_device =
    "EGL offers no device that can be used (gradmesh devices tells why)";

/// Opens the device that may be used; returns null if there is none. Opening one takes a tenth of a
/// second.
std::shared_ptr<Device> open_device(Renderer renderer);

/// Sets where a run finds its errors. Calls `tell` with the reason at once if `egl` is wanted and
/// there is no device, and later, on the thread of the run, if the device fails; the cores do the
/// work then.
void use_renderer(RunOptions& options, Renderer wanted,
                  const std::function<void(const std::string& reason)>& tell);

/// How long pricing takes, found by pricing two small meshes.
struct Speed {
  /// Seconds before the first pixel, and for each pixel (priced_pixels).
  double start = 0, per_pixel = 0;

  double seconds(double pixels) const { return start + per_pixel * pixels; }
};
struct Speeds {
  Speed software, device;
};

/// Returns about how many pixels are painted and measured when the edges and regions of a mesh are
/// priced.
double priced_pixels(const Mesh& mesh, const Frame& frame, MetricKind metric);

/// Measures the speeds of software and device on `threads` threads (0: all cores), which takes
/// about a second. Throws DeviceError.
Speeds measure_speeds(const std::shared_ptr<Device>& device, int threads);
/// Returns the speeds measured when the device was first used with this version and as many
/// threads, which are kept in the user's cache folder; if they cannot be kept they are measured
/// again. Throws DeviceError.
Speeds known_speeds(const std::shared_ptr<Device>& device, int threads);

/// The renderer that is expected to be faster, and why.
struct RendererChoice {
  bool takes_device = false;
  Message reason;
};
RendererChoice faster(const Speeds& speeds, double pixels);
/// Returns what `auto` takes for a mesh, of software and this device; software if the device fails.
RendererChoice choose_renderer(const std::shared_ptr<Device>& device, const Mesh& mesh,
                               const Frame& frame, MetricKind metric, int threads);

/// Returns the device that `auto` takes for a mesh, null for software. No device is started if
/// pricing takes less time than starting one.
std::shared_ptr<Device> automatic_device(const Mesh& mesh, const Frame& frame, MetricKind metric,
                                         int threads);

}  // namespace gradmesh
