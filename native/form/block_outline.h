#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "form/blocks.h"

namespace gradmesh {

/// Returns the path that a block is painted through: its outline, grown outwards by half of the
/// block's smaller side, but at least by `margin` (so that anti-aliasing never shows a seam, and
/// there is room to edit). It is a closed polygon for the fill rule nonzero, in mesh units.
std::vector<glm::dvec2> grown_outline(const Mesh& mesh, const Rectangle& block, double margin);

/// Returns twice the area that the polygon encloses, positive where it is clockwise with y down.
double doubled_area(const std::vector<glm::dvec2>& polygon);

/// Returns the block's own outline as a polygon, with each side of a patch in `steps` pieces.
std::vector<glm::dvec2> block_outline(const Mesh& mesh, const Rectangle& block, int steps);

}  // namespace gradmesh
