#pragma once

#include <cstdint>
#include <vector>

#include "base/image.h"
#include "geom/outline.h"
#include "mesh/mesh.h"
#include "raster/frame.h"

namespace gradmesh {

/// A picture of a mesh alone, with nothing behind it.
struct MeshImage {
  /// Red, green, blue and opacity, colours not multiplied by it. Where the mesh is not they are
  /// those of a nearest pixel where it is: a picture that a path cuts off shows no edge of its own
  /// then, at whatever size it is shown.
  RgbaImage samples;
  /// 1 where the mesh is, 0 elsewhere.
  Raster<std::uint8_t, 1> covered;
};

/// Paints a mesh alone, with the colours that Inkscape's own picture has at this size
/// (make_cairo_like_rasterizer). Hidden pixels are painted too.
MeshImage picture_of(const Mesh& mesh, Frame frame);

/// Returns true if the mesh of a picture, which was painted in that frame, covers pixels that are
/// more than a pixel beyond all outlines of a set, in mesh units.
bool covers_beyond(const MeshImage& picture, const std::vector<FilledOutline>& set,
                   const Frame& frame);

}  // namespace gradmesh
