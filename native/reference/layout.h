#pragma once

#include <optional>
#include <vector>

#include "base/affine.h"
#include "geom/outline.h"
#include "raster/frame.h"
#include "reference/original.h"
#include "reference/weights.h"

namespace gradmesh {

/// How an original is laid out on a picture.
struct Layout {
  /// The map from mesh units to what the person sees, up to scale.
  Affine view = {};
  FramePadding padding = {};
  /// The visible area of the mesh; nothing if all is visible. The rest does not count, as if it
  /// were not painted.
  std::optional<VisibleArea> visible = std::nullopt;
  /// Where errors count more or less than once. Where areas overlap, the last one counts.
  std::vector<WeightedArea> weighted = {};
};

/// Returns the frame of `resolution` pixels along the longer side in which the original lies
/// as `layout` says. Throws InputError as fit_frame does.
Frame laid_out(const Original& original, const Layout& layout, int resolution);

}  // namespace gradmesh
