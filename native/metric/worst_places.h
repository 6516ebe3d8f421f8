#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "base/image.h"

namespace gradmesh {

/// A place of a picture where the error of a detail is large: the middle of a window of 4 x 4
/// pixels (metric/detail_errors.h), and the mean error in it.
struct WorstPlace {
  glm::dvec2 place;
  double error;
};

/// Returns at most that many places, the worst first, of which no two are closer than 32 pixels.
/// `counts` is 0 for pixels that have no error.
std::vector<WorstPlace> worst_places(const Plane& errors, const Raster<std::uint8_t, 1>& counts,
                                     int most);

}  // namespace gradmesh
