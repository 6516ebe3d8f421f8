#pragma once

#include <vector>

#include "methods/plain/plain_grid.h"
#include "methods/plain/steps.h"
#include "reference/reference.h"

namespace gradmesh {

/// What is expected of a grid without one of its lines.
struct LineRise {
  /// The root of the sum by which the squares rise once the points near the line are fitted. The
  /// error rises about in proportion to it.
  double root = 0;
  /// The number of handles that are saved.
  int saved = 0;

  double by_handle() const { return root / saved; }
};

/// Returns what to expect of each line from the equations of a fit (expected_squares), which take a
/// tenth of the time of fitting and measuring.
std::vector<LineRise> rises_without(const PlainGrid& grid, const std::vector<Step>& lines,
                                    const Reference& target);

/// Returns for each side by how much the sum of squares rises if that side alone becomes straight
/// and nothing is fitted.
std::vector<double> rises_if_straight(const PlainGrid& grid, const std::vector<Side>& sides,
                                      const Reference& target);

}  // namespace gradmesh
