#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/affine.h"
#include "formats/pdf/objects/page_path.h"
#include "formats/pdf/objects/qpdf.h"
#include "formats/pdf/page/page_stroke.h"
#include "formats/pdf/text/shown_text.h"

namespace gradmesh {

/// A transparency group (ISO 32000-1, 11.4.5): what is inside is painted, and then all of it is
/// mixed at once with what lies below.
struct PageGroup {
  /// That which it lies in; null if there is none.
  std::shared_ptr<const PageGroup> around = nullptr;
  double opacity = 1;
  /// A CSS word (blend_mode_of).
  std::string blend_mode = "normal";
  /// Whether what is inside is mixed with nothing below the group, and whether it hides what is
  /// inside and below it.
  bool is_isolated = false, is_knockout = false;
  /// Whether a group of SVG looks the same, as far as is known of what is inside.
  bool is_as_in_svg = true;
};

/// Colour spaces by name.
struct NamedSpaces {
  QPDFObjectHandle dictionary;
  /// As PDF writes it, by which it is known again.
  std::string text;
};

struct PaintedShading;
/// The shadings whose luminosity is the opacity of another; null if there is no such mask.
using Mask = std::shared_ptr<const std::vector<PaintedShading>>;

/// A shading where a page paints it.
struct PaintedShading {
  QPDFObjectHandle shading;
  /// The colour spaces that the resources of its content name; null if there are none.
  std::shared_ptr<const NamedSpaces> spaces;
  /// From the shading's coordinates to those of the page.
  Affine to_page;
  Clips clips;
  double opacity = 1;
  Mask mask;
  /// The stroke that it paints; null if it paints an area. The clips are then others than its path.
  std::shared_ptr<const PageStroke> stroke = nullptr;
  /// How it is mixed with what lies below, a CSS word (blend_mode_of).
  std::string blend_mode = "normal";
  /// The group that it lies in; null where that changes nothing (lone_groups.h).
  std::shared_ptr<const PageGroup> group = nullptr;
  /// Whether boxes stand for letters through which it is seen.
  bool has_text_boxes = false;
  /// Whether it lies in the cell of a pattern, of which the page shows more.
  bool is_repeated = false;
};

/// A pattern that fills or strokes.
struct PagePattern {
  QPDFObjectHandle object;
  /// From its coordinates to those of the page: it lies in the content whose resources name it.
  Affine to_page;
  QPDFObjectHandle resources;
  std::shared_ptr<const NamedSpaces> spaces;
};

/// What operators of a content stream set, as far as it counts for shadings (ISO 32000-1, 8.4).
struct GraphicsState {
  Affine to_page;
  Clips clips;
  /// The constant alphas of fills and of strokes.
  double opacity = 1, stroke_opacity = 1;
  std::string blend_mode = "normal";
  std::shared_ptr<const PageGroup> group;
  /// The mask, and that of the groups around.
  Mask mask, group_mask;
  /// What a mask that is an area hides nothing of, and how opaque it is there.
  Clips mask_clips;
  double mask_opacity = 1;
  /// Whether it belongs to a layer that is off, and to the cell of a pattern that is repeated.
  bool is_hidden = false, is_repeated = false;
  /// Whether boxes stand for letters through which all is seen.
  bool has_text_boxes = false;
  /// The stroke that all is seen through, if it is the cell of a pattern that strokes.
  std::shared_ptr<const PageStroke> stroke_around;
  /// The pattern that fills, and that which strokes, if one does.
  std::optional<PagePattern> pattern, stroke_pattern;
  TextStyle text;
  /// With lengths in the coordinates of the content.
  LineStyle line;
};

/// Returns the mask through which is seen what two masks are around: one without shadings, which
/// no mesh can have, where there are both.
Mask through_both(const Mask& one, const Mask& other);

/// Makes what follows belong to a transparency group, which has the opacity of `group`, and the
/// blend mode and the masks of the state so far.
void begin_group(GraphicsState& state, PageGroup group);

/// Returns the CSS word for the /BM of a graphics state, or for the first of several that is known
/// (ISO 32000-1, 11.3.5): "multiply"; "normal" for one that is not known.
std::string blend_mode_of(QPDFObjectHandle modes);

}  // namespace gradmesh
