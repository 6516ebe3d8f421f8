#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>

#include "base/image.h"

namespace gradmesh {

/// Interleaved samples of a window that may stick out of the frame; not initialised.
template <class T>
class WindowPlane {
 public:
  explicit WindowPlane(Window window, int channels = 1)
      : window_(window),
        channels_(channels),
        stride_(std::ptrdiff_t(window.width()) * channels),
        samples_(std::make_unique_for_overwrite<T[]>(stride_ * window.height())) {}

  T* at(int x, int y) { return samples_.get() + offset(x, y); }
  const T* at(int x, int y) const { return samples_.get() + offset(x, y); }
  /// Samples from one row to the next.
  std::ptrdiff_t stride() const { return stride_; }

 private:
  std::ptrdiff_t offset(int x, int y) const {
    return (y - window_.y0) * stride_ + std::ptrdiff_t(x - window_.x0) * channels_;
  }

  Window window_;
  int channels_;
  std::ptrdiff_t stride_;
  std::unique_ptr<T[]> samples_;
};

/// Calls `body(x, y, source_x, source_y)` for every pixel of `window`; the source is the nearest
/// pixel of the frame, which is how every filter of the metrics continues an image.
template <class Body>
void for_each_extended(Window window, Window frame, const Body& body) {
  for (int y = window.y0; y < window.y1; ++y) {
    const int source_y = std::clamp(y, frame.y0, frame.y1 - 1);
    for (int x = window.x0; x < window.x1; ++x) {
      body(x, y, std::clamp(x, frame.x0, frame.x1 - 1), source_y);
    }
  }
}

}  // namespace gradmesh
