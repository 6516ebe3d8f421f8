#pragma once

#include <vector>

#include "app/pages/page_objects.h"
#include "base/affine.h"
#include "formats/svg/tree/flat_tiles.h"

namespace gradmesh {

/// Returns for each object the flat tiles that show the same at the same place, as Inkscape's
/// import of PDF makes them: a group of their own, or those of a run that are inside of the mesh's
/// box and of colours that it has there. None where there are none. `places` are the maps from
/// pixels of the pages to units of the tiles' document. A tile is that of one mesh only.
std::vector<PartOfTiles> tiles_of_meshes(const std::vector<PageObject>& objects,
                                         const std::vector<Affine>& places,
                                         const std::vector<FlatTiles>& runs);

}  // namespace gradmesh
