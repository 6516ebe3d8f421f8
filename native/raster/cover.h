#pragma once

#include "raster/fill.h"

namespace gradmesh {

/// Marks the pixels that the triangles of `shape` cover, with parameters interpolated linearly over
/// each triangle. The caller has set the window of `parameters` and marked all of its pixels as not
/// covered.
void cover(const FaceShape& shape, Parameters& parameters);

/// How many samples beyond its end a row of Parameters may be read and written.
constexpr std::size_t row_padding = 16;

}  // namespace gradmesh
