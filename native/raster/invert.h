#pragma once

#include "raster/fill.h"

namespace gradmesh {

/// Finds the parameters of the pixels of a traced shape. The caller has set the window of
/// `parameters` and marked all of its pixels as not covered.
void invert(const FaceShape& shape, Parameters& parameters);

}  // namespace gradmesh
