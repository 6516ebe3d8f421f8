#pragma once

#include <libxml/tree.h>

#include "form/blocks.h"
#include "formats/svg/gradient/color_texts.h"
#include "formats/svg/values/style.h"
#include "formats/text/number.h"
#include "geom/patch.h"
#include "mesh/parts.h"

namespace gradmesh {

/// The largest coordinate of a patch. It keeps the distances between its points, which are what a
/// document holds, within Scanner's limit.
inline constexpr double largest_reach = 5e8;

/// Returns true if no control point lies beyond largest_reach.
bool is_within_limits(const Patch& patch);
/// Throws InputError about `node` if a patch of the grid is beyond these limits.
void check_limits(const PatchGrid& grid, const xmlNode* node);

/// Returns the patches in the rows below a meshgradient that begins at `start`, in its coordinates
/// and with bilinear colours. Throws InputError at all that Inkscape could not paint.
PatchGrid read_rows(const StyleSheet& styles, const xmlNode* gradient, glm::dvec2 start);

/// Returns the text of a stop's colour, with `currentColor` looked up; an empty string for the
/// black of a stop that has none. A text that is no colour is returned too if no other value
/// counts.
std::string stop_color_text(const StyleSheet& styles, const xmlNode* stop);

/// The part of the colours that a gradient holds: where opacities are in a mask (BlockForm), the
/// mask's gradients hold them as mask_color, and the blocks are opaque. Elsewhere a gradient holds
/// both.
enum class MeshChannel { color, opacity, both };

struct GradientFormat {
  /// Coordinates without a step are written by `rounding`.
  Precision precision = {};
  MeshChannel channel = MeshChannel::both;
  /// True if colours are in `style`, which rules of the document do not override. Attributes are
  /// shorter.
  bool in_style = false;
  /// True if they are `!important` there, as some rule is.
  bool is_important = false;
  Rounding rounding = {};
  /// True if coordinates are multiples of a step, and relative to where the side starts, as they
  /// need not equal those of another gradient, nor what they were to the last bit.
  bool is_relative = false;
  /// The texts of colours that are written as they stood; null if there are none.
  const ColorTexts* texts = nullptr;
};

/// Gives a meshgradient the block's start and rows, in Inkscape's own form: the ends of sides that
/// close patches are there, as its extension Mesh-Gradient to Path needs them.
void write_rows(xmlNode* gradient, const Mesh& mesh, const Rectangle& block,
                const GradientFormat& format);

}  // namespace gradmesh
