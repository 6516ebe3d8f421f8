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

  /// Built when it is first asked for.
  const Program& program(const std::string& source) const;
  /// Throws DeviceError where anything went wrong since the last check.
  void check() const;

 private:
  Device& device_;
  std::unique_lock<std::mutex> lock_;
};

/// Lets go of what lives on a device. Where that is lost, its part goes with the context.
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
