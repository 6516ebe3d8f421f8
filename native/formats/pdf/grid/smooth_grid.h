#pragma once

#include <optional>

#include "formats/pdf/grid/page_grids.h"

namespace gradmesh {

/// A rectangle of patches as an artist has made it, row by row, with side 0 of each at its upper
/// side.
struct ArtistsGrid {
  int rows = 0, columns = 0;
  std::vector<PagePatch> patches;
  /// Whether its colours are those of `type="bicubic"`, not bilinear.
  bool smooth = false;
};

/// Returns the grid of a page as it is.
ArtistsGrid as_it_is(const PageGrid& grid, const PatchSides& sides);

/// Returns the grid with smooth colours as which Inkscape has painted this one: it writes each
/// patch of such a grid as 8 x 8. Returns nothing unless all of them are the parts of a patch and
/// their corners have the colours that Inkscape gives them there, limited to what a colour is.
std::optional<ArtistsGrid> smooth_grid(const ArtistsGrid& painted);

}  // namespace gradmesh
