#pragma once

#include "formats/pdf/objects/page_path.h"
#include "formats/pdf/page/line_style.h"

namespace gradmesh {

/// A path that is stroked, and how: its points and lengths are in page coordinates.
struct PageStroke {
  PagePath path;
  LineStyle line;
};

}  // namespace gradmesh
