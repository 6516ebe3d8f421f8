#pragma once

#include <vector>

#include "base/error.h"
#include "formats/pdf/page/graphics_state.h"
#include "formats/pdf/page/shading_colors.h"
#include "formats/pdf/shading/read_patches.h"

namespace gradmesh {

/// The patches of a shading, where a page paints it or in its own coordinates.
struct PageShading {
  /// 4 to 7.
  int type = 0;
  ShadingColors colors;
  /// A triangle is a patch of which side 2 is one point, which is exact; of a lattice each cell is
  /// two of them, or one patch with straight sides where that is the same.
  std::vector<ShadingPatch> patches;
  /// Whether a part of it could not be read, as it is damaged, or lies beyond any page.
  bool is_damaged = false;
};

/// Thrown for a shading that has more patches than a mesh may have.
struct TooManyPatches : InputError {
  explicit TooManyPatches(std::size_t patches);
  std::size_t count;
};

/// Reads a shading of type 4 to 7, in its own coordinates. `spaces` may be null. Throws InputError,
/// whose message is a clause, where nothing of it can be read.
PageShading unplaced_shading(QPDFObjectHandle shading, const NamedSpaces* spaces);

/// Returns a shading with its patches on the page, without those that have no size there, or lie
/// beyond any page.
PageShading placed(PageShading shading, const Affine& to_page);

/// Reads a shading where a page paints it. Throws InputError as unplaced_shading() does.
PageShading read_shading(const PaintedShading& painted);

}  // namespace gradmesh
