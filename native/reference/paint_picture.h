#pragma once

#include "base/affine.h"
#include "base/image.h"
#include "raster/frame.h"
#include "raster/painting.h"

namespace gradmesh {

/// Paints a picture over the whole of the painting's window, which lies inside the frame, as if it
/// were one face: pixels are covered whose centre is in the picture. `to_units` maps pixels of the
/// picture to the units of the frame. A pixel gets the mean of the samples that the picture,
/// interpolated between the centres of its pixels, has in even steps of at most one of these: so it
/// is interpolated where it is enlarged, copied where it is painted pixel for pixel, and averaged
/// by area where it is reduced.
void paint_picture(const RgbaImage& picture, const Affine& to_units, const Frame& frame,
                   Painting& painting);

}  // namespace gradmesh
