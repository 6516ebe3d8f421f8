#pragma once

#include <vector>

#include "methods/plain/plain_grid.h"
#include "methods/plain/steps.h"
#include "reference/reference.h"

namespace gradmesh {

/// Returns for each side by how much the sum of squares rises if that side alone becomes straight
/// and nothing is fitted.
std::vector<double> rises_if_straight(const PlainGrid& grid, const std::vector<Side>& sides,
                                      const Reference& target);

}  // namespace gradmesh
