#pragma once

#include <memory>

#include "base/affine.h"
#include "simplify/writing_rules.h"

namespace gradmesh {

/// How SVG holds a mesh as a group of blocks.
std::shared_ptr<const WritingRules> block_rules();

/// How SVG holds a mesh that is a grid (find_grid) as one mesh gradient, whose coordinates are
/// those of the mesh under `to_gradient`.
std::shared_ptr<const WritingRules> gradient_rules(const Affine& to_gradient);

}  // namespace gradmesh
