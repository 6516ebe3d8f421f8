#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/parts.h"

namespace gradmesh {

/// The step of which all coordinates of one axis are multiples: 10 or 2 to the power `exponent`.
struct AxisStep {
  bool is_decimal = false;
  int exponent = 0;

  /// Returns so many steps; of a decimal step, the very number that a document says.
  double times(double steps) const;
  /// Returns how many steps a number is.
  double count(double number) const;
  /// Returns how far from where it follows from others, in steps, a point may be that rounding has
  /// put there.
  double noise() const;
};

/// How whole numbers stand for positions and colours.
struct Scale {
  std::array<AxisStep, 2> steps{};
  /// For each channel, the number of steps from 0 to 1.
  std::array<std::int64_t, 4> levels{};
};

/// Returns the scale of these patches. A document's numbers have a decimal step: where all are
/// multiples of one that is at least 2^-precision of the width or height of all patches, nothing is
/// rounded. Elsewhere the step is a power of two that is at most so large. Sides that are lines and
/// patches that are Coons patches have no numbers but those of their corners and sides. Channels
/// have 255 or 1000 levels if all their numbers are such levels, otherwise 65535.
Scale scale_for(const std::vector<PatchGrid>& grids, int precision);

/// Returns true if all coordinates are numbers of at most 1e9.
bool lie_near(const std::vector<PatchGrid>& grids);

}  // namespace gradmesh
