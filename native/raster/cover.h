#pragma once

#include "raster/fill.h"

namespace gradmesh {

/// Marks the pixels that the triangles of `shape` cover, with their parameters interpolated
/// linearly. The window of `parameters` is set, and they are not covered.
void cover(const FaceShape& shape, Parameters& parameters);

/// What rows of Parameters may be read and written beyond their ends.
constexpr std::size_t row_padding = 16;

}  // namespace gradmesh
