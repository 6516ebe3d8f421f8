#pragma once

#include <cstdint>

#include "base/image.h"
#include "mesh/mesh.h"
#include "raster/frame.h"

namespace gradmesh {

/// A picture of a mesh alone, with nothing behind it.
struct MeshPicture {
  /// Red, green, blue and opacity, colours not multiplied by it. Where the mesh is not they are
  /// those of a nearest pixel where it is: a picture that a path cuts off shows no edge of its own
  /// then, at whatever size it is shown.
  RgbaImage samples;
  /// 1 where the mesh is, 0 elsewhere.
  Raster<std::uint8_t, 1> covered;
};

/// Paints a mesh alone, with the colours that Inkscape's own picture has at this size
/// (make_cairo_like_rasterizer). Hidden pixels are painted too.
MeshPicture picture_of(const Mesh& mesh, Frame frame);

}  // namespace gradmesh
