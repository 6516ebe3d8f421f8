#pragma once

#include <string_view>
#include <vector>

#include "formats/pdf/grid/smooth_grid.h"

namespace gradmesh {

/// Reads the meshes that Illustrator keeps for itself beside a page (`/Mesh X!` to `/End X!` in its
/// private data), as the artist drew them: in points, y down, from an origin that the page need not
/// share. They have smooth colours, which are not read: the page has them. A side with anchors is
/// the closest one curve. Records that are broken, or have more than limits().patches patches, are
/// left out.
std::vector<ArtistsGrid> read_mesh_records(std::string_view data);

}  // namespace gradmesh
