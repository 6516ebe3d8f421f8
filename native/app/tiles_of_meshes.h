#pragma once

#include <vector>

#include "app/page_objects.h"
#include "base/affine.h"
#include "formats/svg/tree/flat_tiles.h"

namespace gradmesh {

/// Returns for each object the group of flat tiles that shows the same at the same place, as
/// Inkscape's import of PDF makes; null where there is none. `places` are the maps from pixels of
/// the pages to units of the groups' document. A group is that of one mesh only.
std::vector<const FlatTiles*> tiles_of_meshes(const std::vector<PageObject>& objects,
                                              const std::vector<Affine>& places,
                                              const std::vector<FlatTiles>& groups);

}  // namespace gradmesh
