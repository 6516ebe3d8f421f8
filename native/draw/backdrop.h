#pragma once

#include "draw/drawing.h"
#include "raster/frame.h"

namespace gradmesh {

/// Returns the mesh as painted in `frame`, faded, to lie behind its lines. It is gray if `gray`,
/// for drawings in which colours mean something else. `view` is that of the Subject.
Picture backdrop(Image painted, const Frame& frame, const Affine& view, bool gray);

}  // namespace gradmesh
