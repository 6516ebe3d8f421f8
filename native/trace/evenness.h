#pragma once

#include <vector>

#include "trace/equations.h"

namespace gradmesh {

/// What keeps the lines of a grid from jamming where the picture says little: each three points in
/// a row of a line are drawn together as by springs, weakly, and into a straight line, more
/// strongly. Both in squares of levels a square of a pixel. And patches are kept from becoming
/// slivers (sliver_equations).
struct Evenness {
  double spacing = 6, straightness = 600, slivers = 2e5;
  /// A step makes no corner's area smaller, in square pixels.
  double least_corner = 2;

  Evenness times(double factor) const {
    return {factor * spacing, factor * straightness, factor * slivers, least_corner};
  }
  /// Returns what suits a fit of patches that have so many squares each in the mean: what is weak
  /// where a picture is followed roughly would be strong where it is followed closely.
  Evenness for_patches(double squares) const;
  /// Returns what is next where lines have found their places: less that holds them even.
  Evenness loosened() const { return {0.3 * spacing, 0.3 * straightness, slivers, least_corner}; }
  /// Returns what is last, after so many times, when slivers that are left become wide enough. What
  /// has jammed could not part if a corner had to stay as large as before.
  Evenness loosest() const {
    Evenness last = *this;
    for (int i = 0; i < times_loosened; ++i) last = last.loosened();
    last.slivers *= 64;
    last.least_corner = 0.25;
    return last;
  }
  static constexpr int times_loosened = 4;
};

/// Returns the sum of the squares by which the lines are uneven, and its equations in the places of
/// `columns`.
std::vector<NormalEquations> evenness_equations(const LineGrid& grid, const TargetPicture& target,
                                                const GridColumns& columns, const Evenness& by);

/// Returns the sum of the squares alone.
double unevenness(const LineGrid& grid, const TargetPicture& target, const Evenness& by);

}  // namespace gradmesh
