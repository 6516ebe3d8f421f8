#pragma once

#include "raster/fill.h"

namespace gradmesh {

/// Finds the parameters of the pixels of a traced shape. The window of `parameters` is set, and
/// they are not covered.
void invert(const FaceShape& shape, Parameters& parameters);

}  // namespace gradmesh
