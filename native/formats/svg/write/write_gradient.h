#pragma once

#include <libxml/tree.h>

#include <string>

#include "base/affine.h"
#include "form/blocks.h"
#include "formats/svg/read/document.h"
#include "formats/text/number.h"

namespace gradmesh {

/// What of the colours a gradient holds: where opacities are in a mask (BlockForm), they are
/// written as mask_color, and the blocks opaque. Elsewhere a gradient holds both.
enum class MeshChannel { color, opacity, both };

struct GradientFormat {
  /// How far an interior point may be from the Coons patch's without `tensor` being written.
  double coons_tolerance = 0;
  MeshChannel channel = MeshChannel::both;
  /// Numbers and colours to the last bit, instead of as many digits as Inkscape keeps, and bytes.
  bool exact = false;
  /// Whether opacities are those that a mask can hold.
  bool masked_opacity = false;
  /// From the mesh's coordinates to those of the gradient.
  Affine place = {};
  Rounding rounding = {};
};

/// Gives a meshgradient the block's start and rows.
void write_block_rows(xmlNode* gradient, const Mesh& mesh, const Block& block,
                      const GradientFormat& format);

/// Adds to `defs` a meshgradient in userSpaceOnUse that holds the block, in Inkscape's own form
/// (closing end points present). Each point is rounded once and written absolutely, so
/// that blocks that share it name the very same coordinates and Inkscape's mesh tool joins them.
/// Returns the gradient's id, which begins with `prefix`.
std::string write_block_gradient(SvgDocument& document, xmlNode* defs, const Mesh& mesh,
                                 const Block& block, const GradientFormat& format,
                                 const std::string& prefix);

}  // namespace gradmesh
