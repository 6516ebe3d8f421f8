#pragma once

#include "app/document/mesh_source.h"
#include "base/image.h"
#include "raster/rasterizer.h"

namespace gradmesh {

/// Paints a mesh in its own frame. If there is a document `framed_as`, paints the mesh in the frame
/// of its counterpart there (document/frames.h), so that the two pictures can be laid on each
/// other.
Image render(const MeshSource& document, const MeshEntry& entry, int resolution,
             const Rasterizer& rasterizer, const MeshSource* framed_as = nullptr);
/// Returns the picture that Inkscape paints of the mesh, in the same frame. Throws if the colours
/// are bicubic, which Inkscape cannot paint.
Image render_like_inkscape(const MeshSource& document, const MeshEntry& entry, int resolution,
                           const MeshSource* framed_as = nullptr);
/// Paints a mesh in its own frame, as render() does in software, with its curves over it.
Image picture_with_lines(const MeshSource& document, const MeshEntry& entry, int resolution);

/// Returns one picture right of another, on white.
Image beside(const Image& left, const Image& right);

}  // namespace gradmesh
