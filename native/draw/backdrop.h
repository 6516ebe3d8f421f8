#pragma once

#include "draw/drawing.h"
#include "raster/frame.h"

namespace gradmesh {

/// The mesh as painted in `frame`, faded, to lie behind its lines; `gray` where colours mean
/// something else. `view` as of the Subject.
Picture backdrop(Image painted, const Frame& frame, const Affine& view, bool gray);

}  // namespace gradmesh
