#pragma once

#include <libxml/tree.h>

#include <string>

#include "io/blocks.h"
#include "io/svg_document.h"

namespace gradmesh {

/// Blocks are written opaque, since neighbours both paint the pixels between them. The opacities of
/// a mesh that has any are written as greys, for a mask.
enum class MeshChannel { color, opacity };

/// Adds to `defs` a meshgradient in userSpaceOnUse that holds the block, in Inkscape's own form
/// (FACTS 1: closing end points present). Each point is rounded once and written absolutely, so
/// that blocks that share it name the very same coordinates and Inkscape's mesh tool joins them.
/// `tensor` is written where an interior point is more than `coons_tolerance` from the Coons
/// patch's. Returns the gradient's id, which begins with `prefix`.
std::string write_block_gradient(SvgDocument& document, xmlNode* defs, const Mesh& mesh,
                                 const Block& block, double coons_tolerance, MeshChannel channel,
                                 const std::string& prefix);

}  // namespace gradmesh
