#pragma once

#include <memory>
#include <vector>

#include "geom/outline.h"
#include "raster/frame.h"

namespace gradmesh {

/// What shapes cover, and how often errors there count, least_weight to most_weight
/// (metric/metric.h).
struct WeightedArea {
  std::vector<FilledOutline> shapes;
  double factor = 1;
};

/// Returns the weights of the pixels of the frame, areas being in mesh units: of each pixel the
/// factor of the last area that it meets (HiddenPixels), 1 if it meets none. Returns null if all
/// are 1.
std::shared_ptr<const Plane> weights_in(const Frame& frame, const std::vector<WeightedArea>& areas);

}  // namespace gradmesh
