#pragma once

#include <optional>
#include <vector>

#include "formats/pdf/objects/page_path.h"

namespace gradmesh {

/// A path that is filled, what it is seen through included, and how opaque it is.
struct MaskArea {
  Clips clips;
  double opacity = 1;
};

/// What the form of a soft mask paints beside meshes.
struct MaskMarks {
  std::vector<MaskArea> areas;
  /// Whether there are others, such as strokes, pictures and text.
  bool has_others = false;
};

/// Returns the one area that is as opaque as all of them together; nothing if there is none.
/// Without any it is empty.
std::optional<MaskArea> area_of(const MaskMarks& marks);

}  // namespace gradmesh
