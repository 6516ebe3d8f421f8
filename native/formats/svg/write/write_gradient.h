#pragma once

#include <libxml/tree.h>

#include <string>

#include "base/affine.h"
#include "form/blocks.h"
#include "formats/svg/read/document.h"
#include "formats/text/number.h"

namespace gradmesh {

/// The part of the colours that a gradient holds: where opacities are in a mask (BlockForm), the
/// mask's gradients hold them as mask_color, and the blocks are opaque. Elsewhere a gradient holds
/// both.
enum class MeshChannel { color, opacity, both };

struct GradientFormat {
  /// How far an interior control point may be from the Coons patch's without `tensor` being
  /// written.
  double coons_tolerance = 0;
  MeshChannel channel = MeshChannel::both;
  /// True if colours are in `style`, which rules of the document do not override. Attributes are
  /// shorter.
  bool in_style = false;
  /// The map from the mesh's coordinates to those of the gradient.
  Affine place = {};
  /// A decimal step of which coordinates are multiples (form/rounding.h); 0: they are written by
  /// `rounding`.
  double step = 0;
  Rounding rounding = {};
  /// True if coordinates are multiples of a step, and relative to where the side starts, as they
  /// need not equal those of another gradient.
  bool is_relative = false;
};

/// Gives a meshgradient the block's start and rows.
void write_block_rows(xmlNode* gradient, const Mesh& mesh, const Rectangle& block,
                      const GradientFormat& format);

/// Adds to `defs` a meshgradient in userSpaceOnUse that holds the block, in Inkscape's own form:
/// the ends of sides that close patches are there, as its extension Mesh-Gradient to Path needs
/// them. Each point is rounded once and written in absolute coordinates, so that blocks that share
/// a point have the very same coordinates there and Inkscape's mesh tool joins them. Returns the
/// gradient's id, which begins with `prefix`.
std::string write_block_gradient(SvgDocument& document, xmlNode* defs, const Mesh& mesh,
                                 const Rectangle& block, const GradientFormat& format,
                                 const std::string& prefix);

}  // namespace gradmesh
