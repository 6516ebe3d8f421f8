#pragma once

#include <cstdint>

#include "base/image.h"
#include "mesh/elements.h"
#include "mesh/mesh.h"
#include "raster/frame.h"

namespace gradmesh {

/// What lies on top at a pixel: none, or a face, and whether other faces may lie below it. Faces
/// are painted in the order of their indices, so of those that cover a pixel the greatest is on
/// top, in whatever order they are in fact painted.
class TopFace {
 public:
  TopFace() = default;
  /// Makes a TopFace of a sample of Painting::top.
  explicit TopFace(std::uint32_t sample) : sample_(sample) {}

  /// Returns the face on top; invalid where nothing is painted.
  Face face() const { return {int(sample_ >> 1) - 1}; }
  bool covers_others() const { return sample_ & 1; }
  std::uint32_t sample() const { return sample_; }

  /// Returns the TopFace after one more face is painted in the pixel, which may be the face that is
  /// there.
  TopFace with(Face f) const {
    const std::uint32_t alone = std::uint32_t(f.value + 1) << 1;
    if (sample_ == 0 || sample_ >> 1 == alone >> 1) return TopFace(sample_ | alone);
    return TopFace(std::max(sample_, alone) | 1);
  }

 private:
  std::uint32_t sample_ = 0;
};

/// A painted picture and the face that lies on top at each of its pixels. Of a smooth mesh the
/// faces are those of its painted_mesh.
struct Painting {
  Image image;
  /// Samples of TopFace over the window of `image`; zero where nothing is painted.
  Raster<std::uint32_t, 1> top;

  Painting() = default;
  explicit Painting(Window window) : image(window), top(window) {}

  Window window() const { return image.window(); }
  /// Takes away what is painted in `to_clear`, which lies inside the painting's window, down to a
  /// ground of that grey.
  void clear(Window to_clear, std::uint8_t ground) {
    fill(image, to_clear, ground);
    fill(top, to_clear, TopFace().sample());
  }
};

/// Copies the pixels of a window that lies in both paintings.
inline void copy(const Painting& from, Window window, Painting& to) {
  copy(from.image, window, to.image);
  copy(from.top, window, to.top);
}

/// Calls `f(run, top)` for the pixels of a window, row by row, in runs with the same TopFace; runs
/// without a face are left out.
template <class F>
void for_each_run(const Raster<std::uint32_t, 1>& top, Window window, const F& f) {
  for (int y = window.y0; y < window.y1; ++y) {
    const std::uint32_t* const row = top.at(window.x0, y);
    for (int end = 0, begin = 0; begin < window.width(); begin = end) {
      for (end = begin + 1; end < window.width() && row[end] == row[begin];) ++end;
      const TopFace here(row[begin]);
      if (here.face().valid()) f(Window{window.x0 + begin, y, window.x0 + end, y + 1}, here);
    }
  }
}

/// Paints the whole frame, on all cores.
Painting paint_whole(const Mesh& mesh, const Frame& frame);

/// Paints the whole of the painting's window, which lies inside the frame, on all cores.
void paint_whole(const Mesh& mesh, const Frame& frame, Painting& painting);

}  // namespace gradmesh
