#pragma once

#include "geom/patch.h"

namespace gradmesh {

/// The patch as an SVG document can hold it, for the colour model `bilinear`: corner colours
/// rounded to 8 bits, opacities to those of mask_color where they are in a mask, colours bilinear
/// between them, and the interior control points those of the Coons patch where all four are within
/// `tolerance` of these (in the unit of the positions), since then no `tensor` is written.
Patch as_written(const Patch& patch, double tolerance, bool masked_opacity = false);

/// Whether the patch needs `tensor`.
bool needs_tensor(const Patch& patch, double tolerance);

/// The colour of 8 bits a channel whose luminance in a mask is nearest to an opacity, and of those
/// the nearest to grey. Steps of a single channel are finer than those of greys, so it is within a
/// twentieth of a level.
glm::dvec3 mask_color(double opacity);
/// The luminance of a colour in a mask.
double mask_opacity(const glm::dvec3& color);

}  // namespace gradmesh
