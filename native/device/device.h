#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/message.h"

namespace gradmesh {

/// What a device cannot do, or can do no more: it is lost, out of memory, or lacks something. The
/// software path can always go on instead.
class DeviceError : public std::runtime_error {
 public:
  explicit DeviceError(Message message)
      : runtime_error(message.english()), message_(std::move(message)) {}

  /// What happened, as the end of a sentence: "the device was lost".
  const Message& message() const { return message_; }

 private:
  Message message_;
};

/// A device that EGL offers.
struct DeviceInfo {
  /// As its driver calls itself, with the version.
  std::string name, version;
  /// Whether it is real hardware, not a program that takes its place.
  bool is_hardware = false;
  /// Why it cannot be used; empty: it can.
  std::string problem;
};

/// A device that computes, without a window or a display server: OpenGL 4.3, or OpenGL ES 3.2, by
/// EGL, which is loaded when it is first asked for. May be used by any thread, one at a time.
class Device {
 public:
  /// All devices, hardware first. Empty where there is no EGL.
  static std::vector<DeviceInfo> list();
  /// The first that can be used; null where there is none. `hardware_only`: no program in its
  /// place.
  static std::shared_ptr<Device> open(bool hardware_only);
  ~Device();

  const DeviceInfo& info() const { return info_; }

  /// Whether it has failed, and will again.
  bool is_lost() const { return is_lost_; }
  /// For tests: the `uses`-th use from now on, and all after, fail as if the device had been lost.
  void lose_after(int uses) { uses_left_ = uses; }

  /// While it lives the device is the calling thread's; others wait. Throws DeviceError where the
  /// device is lost.
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
