#pragma once

#include "raster/painting.h"
#include "raster/parameters.h"
#include "raster/patch_color.h"

namespace gradmesh {

/// Paints a face over `window`, which lies inside the painting's window. `parameters` is working
/// memory.
void fill_face(const FaceShape& shape, Face face, const PatchColor& color, Window window,
               Parameters& parameters, Painting& painting);

}  // namespace gradmesh
