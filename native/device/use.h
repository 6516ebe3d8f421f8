#pragma once

#include <mutex>
#include <optional>

#include "device/device.h"
#include "device/gl_objects.h"

namespace gradmesh {

class Device::Use {
 public:
  explicit Use(Device& device);
  ~Use();
  Use(const Use&) = delete;
  Use& operator=(const Use&) = delete;

  /// Returns the program of this source, built at the first call.
  const Program& program(const std::string& source) const;
  /// Throws DeviceError if anything went wrong since the last check.
  void check() const;

 private:
  Device& device_;
  std::unique_lock<std::mutex> lock_;
};

/// Releases objects that live on a device. Where the device is lost, their part on it is freed with
/// the context.
template <class Objects>
void release_on(Device& device, std::unique_ptr<Objects>& objects) {
  std::optional<Device::Use> use;
  try {
    use.emplace(device);
  } catch (const DeviceError&) {
    // No context is current then, which Buffer looks at.
  }
  objects.reset();
}

}  // namespace gradmesh
