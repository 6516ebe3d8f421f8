#pragma once

#include "base/image.h"
#include "geom/patch.h"
#include "raster/painting.h"
#include "raster/tessellate.h"

namespace gradmesh {

/// Colour of a patch at (u, v), ready to be evaluated at many pixels: 8-bit sRGB over white.
class PatchColor {
 public:
  PatchColor(const Patch& patch, ColorModel model, bool masked_opacity = false);
  std::array<std::uint8_t, 3> at(float u, float v) const;

 private:
  using Quad = std::array<float, 4>;
  bool bilinear_;
  bool opaque_;
  bool masked_opacity_;
  /// Coefficients of u^i v^j, times 255; `bilinear` needs the first two of each only.
  std::array<std::array<Quad, 4>, 4> c_{};
};

/// Paints the pixels of `window` whose centres the triangle covers. A centre on an edge belongs
/// to exactly one of the two triangles beside it.
void fill_triangle(const Triangle& triangle, Face face, const PatchColor& color, Window window,
                   Painting& painting);

}  // namespace gradmesh
