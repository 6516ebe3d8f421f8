#pragma once

#include "base/affine.h"
#include "formats/pdf/objects/page_path.h"
#include "formats/pdf/objects/qpdf.h"

namespace gradmesh {

/// A cell of a tiling pattern (ISO 32000-1, 8.7.3).
struct PatternCell {
  /// Where its origin lies, in the coordinates of the pattern.
  glm::dvec2 place{0.0};
  /// Whether no other cell reaches the path.
  bool is_only = true;
};

/// Returns the cell of a pattern that lies nearest to the middle of a path which it paints.
/// `to_page` maps the pattern's coordinates to those of the page.
PatternCell cell_within(QPDFObjectHandle pattern, const Affine& to_page, const PagePath& path);

}  // namespace gradmesh
