#pragma once

#include <memory>

#include "base/affine.h"
#include "problem/writing_rules.h"

namespace gradmesh {

/// Returns the rules by which SVG holds a mesh as a group of blocks.
std::shared_ptr<const WritingRules> block_rules();

/// Returns the rules for a mesh that is only converted: coordinates have nine digits, however few
/// would do for the resolution.
std::shared_ptr<const WritingRules> exact_block_rules();

/// Returns the rules by which SVG holds a mesh that is a grid (find_grid) as one mesh gradient,
/// whose coordinates are those of the mesh mapped by `to_gradient`.
std::shared_ptr<const WritingRules> gradient_rules(const Affine& to_gradient);

}  // namespace gradmesh
