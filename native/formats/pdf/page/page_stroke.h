#pragma once

#include "base/affine.h"
#include "formats/pdf/objects/page_path.h"
#include "formats/pdf/page/line_style.h"

namespace gradmesh {

/// A path that is stroked, and how: its points and lengths are in page coordinates.
struct PageStroke {
  PagePath path;
  LineStyle line;
  /// From the coordinates in which the line is as wide in all directions to those of the page. It
  /// leaves areas as they are.
  Affine pen = {};
};

/// Returns the stroke of a path, which is in page coordinates, by a line which is in those of the
/// content.
PageStroke page_stroke(PagePath path, LineStyle line, const Affine& to_page);

}  // namespace gradmesh
