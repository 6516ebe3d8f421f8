#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/message.h"

namespace gradmesh {

/// Thrown when a device is lost, out of memory, or lacks something. The software path can always go
/// on instead.
class DeviceError : public std::runtime_error {
 public:
  explicit DeviceError(Message message)
      : runtime_error(message.english()), message_(std::move(message)) {}

  /// Returns what happened, as the end of a sentence: "the device was lost".
  const Message& message() const { return message_; }

 private:
  Message message_;
};

/// A device that EGL offers.
struct DeviceInfo {
  /// Name and version that the driver gives.
  std::string name, version;
  /// True if it is real hardware, not a program that takes its place.
  bool is_hardware = false;
  /// Why the device cannot be used; empty if it can.
  std::string problem;
};

/// A device that computes, without a window or a display server: OpenGL 4.3, or OpenGL ES 3.2, by
/// EGL, which is loaded at first use. Any thread may use the device, one at a time.
class Device {
 public:
  /// Returns all devices, hardware first; empty where there is no EGL.
  static std::vector<DeviceInfo> list();
  /// Opens the first device that can be used; returns null if there is none. With `hardware_only`
  /// programs in the place of hardware are left out.
  static std::shared_ptr<Device> open(bool hardware_only);
  ~Device();

  const DeviceInfo& info() const { return info_; }

  /// Returns true if the device has failed; it will then fail again.
  bool is_lost() const { return is_lost_; }
  /// For tests: the `uses`-th use from now on, and all after, fail as if the device had been lost.
  void lose_after(int uses) { uses_left_ = uses; }

  /// Reserves the device for the calling thread as long as the Use lives; other threads wait.
  /// Throws DeviceError where the device is lost.
  class Use;

 private:
  struct Context;
  explicit Device(std::unique_ptr<Context> context);

  DeviceInfo info_;
  std::unique_ptr<Context> context_;
  int uses_left_ = -1;
  bool is_lost_ = false;
};

}  // namespace gradmesh
