#pragma once

#include "geom/patch.h"

namespace gradmesh {

/// The patch as an SVG document can hold it, for the colour model `bilinear`: corner colours
/// rounded to 8 bits, and opacities too where they are the greys of a mask, colours bilinear
/// between them, and the interior control points those of the Coons patch where all four are within
/// `tolerance` of these (in the unit of the positions), since then no `tensor` is written.
Patch as_written(const Patch& patch, double tolerance, bool masked_opacity = false);

/// Whether the patch needs `tensor`.
bool needs_tensor(const Patch& patch, double tolerance);

}  // namespace gradmesh
