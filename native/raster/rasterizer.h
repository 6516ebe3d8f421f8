#pragma once

#include <memory>

#include "base/image.h"
#include "mesh/mesh.h"
#include "raster/frame.h"

namespace gradmesh {

/// Paints a mesh as it will be shown, on white: 8-bit sRGB, one sample for each pixel, no
/// anti-aliasing, opacity over white. Patches are painted in the order of their faces, and where a
/// patch folds over itself the larger v, then the larger u, lies on top. A pixel's sample is
///   bilinear  the one that cairo takes, and so Inkscape, of the mesh as written (forward.h)
///   bicubic   the one at its centre, as in the paper
class Rasterizer {
 public:
  virtual ~Rasterizer() = default;

  /// Paints the pixels of `window`, white where the mesh is not; `image` has the frame's size.
  /// Each pixel's value does not depend on the window. Thread-safe.
  virtual void paint(const Mesh& mesh, const Frame& frame, Window window, Image& image) const = 0;

  Image paint(const Mesh& mesh, const Frame& frame) const {
    Image image(frame.width, frame.height);
    paint(mesh, frame, frame.window(), image);
    return image;
  }
};

/// The reference. Bicubic patches are divided until they are within a tenth of a pixel of the
/// surface; their colour is worked out at each pixel.
std::unique_ptr<Rasterizer> make_software_rasterizer();

}  // namespace gradmesh
