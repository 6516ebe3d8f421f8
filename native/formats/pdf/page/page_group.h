#pragma once

#include <memory>
#include <string>

namespace gradmesh {

/// A transparency group (ISO 32000-1, 11.4.5): what is inside is painted, and then all of it is
/// mixed at once with what lies below.
struct PageGroup {
  /// That which it lies in; null if there is none.
  std::shared_ptr<const PageGroup> around = nullptr;
  double opacity = 1;
  /// A CSS word (blend_mode.h).
  std::string blend_mode = "normal";
  /// Whether what is inside is mixed with nothing below the group, and whether it hides what is
  /// inside and below it.
  bool is_isolated = false, is_knockout = false;
  /// Whether a group of SVG looks the same, as far as is known of what is inside.
  bool is_as_in_svg = true;
};

}  // namespace gradmesh
