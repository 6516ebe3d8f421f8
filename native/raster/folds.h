#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>

#include "base/clamped_int.h"
#include "geom/patch.h"
#include "raster/bicubic.h"

namespace gradmesh {

/// Where a patch surely does not fold: for each of 8 x 8 cells of its parameters the sign of the
/// Jacobian H_u x H_v, or 0 where the Jacobian may change its sign or come close to zero.
struct Folds {
  static constexpr int cells = 8;

  /// The signs of the cells, the first index along u.
  std::array<std::array<std::int8_t, cells>, cells> sign;

  bool possible() const {
    for (const auto& row : sign)
      for (const std::int8_t s : row)
        if (s == 0) return true;
    return false;
  }
  int sign_at(double u, double v) const { return sign[cell(u)][cell(v)]; }
  /// Returns the cell of a parameter in [0, 1].
  static int cell(double t) { return clamped_int(t * cells, 0, cells - 1); }
};

/// Returns the folds of a patch; `bezier` holds the Bezier points of its position.
Folds folds_of(const Bicubic<glm::dvec2>& bezier);

/// Returns true if the patch may lie over itself. Where a patch does, what shows depends on the
/// order in which patches are painted, which changes when a person goes on editing.
bool may_fold(const Patch& patch);

}  // namespace gradmesh
