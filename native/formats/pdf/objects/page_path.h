#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <memory>
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

    bool operator==(const Step&) const = default;
  };

  std::vector<Step> steps;
  FillRule rule = FillRule::nonzero;

  bool operator==(const PagePath&) const = default;
};

/// All that is seen through: what is painted lies inside of each.
using Clips = std::vector<std::shared_ptr<const PagePath>>;

}  // namespace gradmesh
