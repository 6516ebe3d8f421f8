#pragma once

#include "draw/drawing.h"
#include "raster/frame.h"

namespace gradmesh {

/// Takes all colour away from a picture, which then lies behind colours that mean something else.
void make_gray(Image& image);

/// Returns the mesh as painted in `frame`, faded, to lie behind its lines. It is gray if `gray`.
/// `view` is that of the Subject.
PlacedImage backdrop(Image painted, const Frame& frame, const Affine& view, bool gray);

}  // namespace gradmesh
