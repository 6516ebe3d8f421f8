#pragma once

#include "base/affine.h"
#include "mesh/mesh.h"
#include "session/canvas.h"

namespace gradmesh {

/// What makes lines seen that are light, or of another ink, over light pictures.
extern const Ink below_lines;

/// Draws the curves of a mesh over its picture, so that they are seen on light and dark pictures.
void draw_lines(Canvas& canvas, const Mesh& mesh, const Affine& to_pixels);

}  // namespace gradmesh
