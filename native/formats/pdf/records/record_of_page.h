#pragma once

#include <optional>
#include <vector>

#include "formats/pdf/grid/page_colors.h"
#include "formats/pdf/grid/smooth_grid.h"

namespace gradmesh {

/// Returns a record where it lies on the page, with the colours that are there, if the page's
/// patches are parts of it: all its corners, moved by the same, are corners of theirs, and their
/// outlines are as large. Records may disagree with the page, and stand for what is hidden or lies
/// on another artboard.
std::optional<ArtistsGrid> record_of_page(ArtistsGrid record, const std::vector<PagePatch>& page,
                                          const PageColors& colors);

}  // namespace gradmesh
