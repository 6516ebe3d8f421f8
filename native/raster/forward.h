#pragma once

#include "base/affine.h"
#include "base/image.h"
#include "geom/patch.h"

namespace gradmesh {

/// Paints a patch with bilinear colour as cairo paints it, and so Inkscape: by forward
/// rasterization (Popescu and Rosen). The patch is sampled in steps of less than 1 / sqrt(2)
/// pixel, v by v and along each u, so every pixel that it covers holds a sample; the last sample
/// in a pixel colours it. That lies beside the centre, towards the larger u and v, and pixels
/// that the patch only touches are painted too. Numbers are rounded where cairo rounds them: FLIP
/// charges 0.03 for a single level of difference.
void paint_forward(const Patch& patch, const Affine& to_pixels, Window window, Image& image);

}  // namespace gradmesh
