#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "form/blocks.h"

namespace gradmesh {

/// The path that a block is painted through: its outline, grown outwards by half of the block's
/// smaller side, but at least by `margin` (so that anti-aliasing never shows a seam, and there
/// is room to edit). A closed polygon for the fill rule nonzero, in mesh units.
std::vector<glm::dvec2> grown_outline(const Mesh& mesh, const Block& block, double margin);

/// Twice the area that the block's outline encloses; the sign tells the sense of rotation.
double doubled_area(const std::vector<glm::dvec2>& polygon);

/// The block's own outline as a polygon, each side of a patch in `steps` pieces.
std::vector<glm::dvec2> block_outline(const Mesh& mesh, const Block& block, int steps);

}  // namespace gradmesh
