#pragma once

#include <memory>

#include "base/image.h"
#include "mesh/mesh.h"
#include "raster/frame.h"

namespace gradmesh {

/// Paints a mesh as it will be written, on white: 8-bit sRGB, one sample a pixel, no
/// anti-aliasing, opacity over white. Patches are painted in the order of their faces, and where a
/// patch folds over itself the larger v, then the larger u, lies on top.
class Rasterizer {
 public:
  virtual ~Rasterizer() = default;

  /// Returns an image of the frame's size, white where the mesh is not. Thread-safe.
  virtual Image paint(const Mesh& mesh, const Frame& frame) const = 0;
};

/// Returns the reference rasterizer, which samples at the centres of pixels as the paper does:
/// every patch is divided until it is within a tenth of a pixel of the surface, and the colour is
/// worked out at each pixel.
std::unique_ptr<Rasterizer> make_software_rasterizer();

/// Returns a rasterizer that paints as cairo and thus Inkscape do, down to the roundings: it
/// samples at another point of each pixel, and paints pixels that a patch only touches. It serves
/// to compare our surface with Inkscape's own pictures. Colours are taken as bilinear between the
/// corners of the patches.
std::unique_ptr<Rasterizer> make_cairo_like_rasterizer();

}  // namespace gradmesh
