#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>

#include "geom/patch.h"
#include "raster/bicubic.h"

namespace gradmesh {

/// Where a patch surely does not fold: its parameters in 8 x 8 cells, for each the sign of the
/// Jacobian H_u x H_v, or 0 where that may change or come close to zero.
struct Folds {
  static constexpr int cells = 8;

  /// The first index along u.
  std::array<std::array<std::int8_t, cells>, cells> sign;

  bool possible() const {
    for (const auto& row : sign)
      for (const std::int8_t s : row)
        if (s == 0) return true;
    return false;
  }
  int sign_at(double u, double v) const { return sign[cell(u)][cell(v)]; }
  /// The cell of a parameter in [0, 1].
  static int cell(double t) { return t < 1 ? int(t * cells) : cells - 1; }
};

/// `bezier` holds the Bezier points of the position.
Folds folds_of(const Bicubic<glm::dvec2>& bezier);

/// Whether the patch may lie over itself. Where it does, what shows depends on the order in which
/// patches are painted, which changes when a person goes on editing.
bool may_fold(const Patch& patch);

}  // namespace gradmesh
