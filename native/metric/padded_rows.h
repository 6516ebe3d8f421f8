#pragma once

#include <hwy/aligned_allocator.h>

#include <algorithm>
#include <cstddef>
#include <new>

#include "base/image.h"

namespace gradmesh {

/// Planes of samples over a window, which may extend beyond the frame, for loops over whole
/// vectors: a row starts at a multiple of the vector's size, and behind it lie at least `padding`
/// samples that may be read and written.
template <class Sample>
class PaddedRows {
 public:
  static constexpr int padding = 16;  ///< In samples; no vector is longer.

  /// Moves the planes to another window, after which the samples may have any values. Takes new
  /// memory only where more is needed than ever before.
  void reset(Window window, int planes) {
    window_ = window;
    planes_ = planes;
    stride_ = (window.width() + padding - 1) / padding * padding + padding;
    const std::size_t size = std::size_t(stride_) * window.height() * planes;
    if (size <= capacity_) return;
    samples_ = hwy::AllocateAligned<Sample>(size);
    capacity_ = samples_ ? size : 0;
    if (!samples_) throw std::bad_alloc();
    // The samples behind a row do not count, but a comparison of whole vectors may branch on them.
    std::fill_n(samples_.get(), size, Sample(0));
  }

  void clear() { std::fill_n(samples_.get(), offset(planes_, window_.y0), Sample(0)); }

  Window window() const { return window_; }
  int planes() const { return planes_; }
  /// Returns the number of samples from one row to the next.
  std::ptrdiff_t stride() const { return stride_; }

  /// Returns a pointer to the first sample of row y.
  Sample* row(int plane, int y) { return samples_.get() + offset(plane, y); }
  const Sample* row(int plane, int y) const { return samples_.get() + offset(plane, y); }
  /// Returns a pointer to the sample at (x, y); those to its right follow.
  Sample* at(int plane, int x, int y) { return row(plane, y) + (x - window_.x0); }
  const Sample* at(int plane, int x, int y) const { return row(plane, y) + (x - window_.x0); }

 private:
  std::ptrdiff_t offset(int plane, int y) const {
    return (std::ptrdiff_t(plane) * window_.height() + y - window_.y0) * stride_;
  }

  Window window_;
  int planes_ = 0;
  std::ptrdiff_t stride_ = 0;
  std::size_t capacity_ = 0;
  hwy::AlignedFreeUniquePtr<Sample[]> samples_;
};

/// Gives every pixel beyond `inside`, a part of the window, the samples of the nearest pixel in
/// `inside`, which is how every filter of the metrics continues an image.
template <class Sample>
void extend(PaddedRows<Sample>& rows, Window inside) {
  const Window window = rows.window();
  for (int plane = 0; plane < rows.planes(); ++plane) {
    for (int y = inside.y0; y < inside.y1; ++y) {
      Sample* first = rows.at(plane, inside.x0, y);
      Sample* end = rows.at(plane, inside.x1, y);
      std::fill(rows.row(plane, y), first, *first);
      std::fill(end, rows.at(plane, window.x1, y), end[-1]);
    }
    const Sample *top = rows.row(plane, inside.y0), *bottom = rows.row(plane, inside.y1 - 1);
    for (int y = window.y0; y < inside.y0; ++y)
      std::copy_n(top, window.width(), rows.row(plane, y));
    for (int y = inside.y1; y < window.y1; ++y)
      std::copy_n(bottom, window.width(), rows.row(plane, y));
  }
}

}  // namespace gradmesh
