#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <vector>

#include "geom/outline.h"

namespace gradmesh {

/// A path of a page, in page coordinates: cubic curves and straight lines, which a reader need not
/// flatten.
struct PagePath {
  struct Step {
    enum class Kind { move, line, curve, close };
    Kind kind = Kind::close;
    /// Where it leads is the last point; a curve has its two control points before that.
    std::array<glm::dvec2, 3> points{};
  };

  std::vector<Step> steps;
  FillRule rule = FillRule::nonzero;
};

}  // namespace gradmesh
