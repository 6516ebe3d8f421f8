#pragma once

#include <vector>

#include "trace/equations.h"

namespace gradmesh {

/// What keeps the lines of a grid from jamming where the picture says little: each three points in
/// a row of a line are drawn together as by springs, weakly, and into a straight line, more
/// strongly. Both in squares of levels a square of a pixel.
struct Evenness {
  double spacing = 3, straightness = 300;

  Evenness times(double factor) const { return {factor * spacing, factor * straightness}; }
};

/// Returns the sum of the squares by which the lines are uneven, and its equations in the places of
/// `columns`.
std::vector<NormalEquations> evenness_equations(const LineGrid& grid, const TargetPicture& target,
                                                const GridColumns& columns, const Evenness& by);

/// Returns the sum of the squares alone.
double unevenness(const LineGrid& grid, const TargetPicture& target, const Evenness& by);

}  // namespace gradmesh
