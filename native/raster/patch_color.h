#pragma once

#include <cstdint>

#include "geom/patch.h"
#include "mesh/mesh.h"
#include "raster/bicubic.h"

namespace gradmesh {

/// The colour of a patch, ready to be worked out at many pixels.
struct PatchColor {
  PatchColor(const Patch& patch, ColorModel model, bool masked_opacity, std::uint8_t ground = 255);

  /// True if only the coefficients of 1, u, v and uv count.
  bool bilinear;
  bool opaque = true;
  /// True if the picture under the mask and the mask have 8 bits each.
  bool masked_opacity;
  /// The grey that shows through, in levels of 0..255.
  float ground;
  /// Coefficients of u^i v^j of r, g, b and a; r, g and b in levels of 0..255.
  std::array<Bicubic<float>, 4> channels;
};

}  // namespace gradmesh
