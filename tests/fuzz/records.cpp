#include <cmath>

#include "formats/pdf/records/mesh_records.h"
#include "target.h"

namespace gradmesh::fuzz {

/// What Illustrator keeps for itself beside a page, as far as it is about meshes.
void check(std::string_view data) {
  for (const ArtistsGrid& grid : read_mesh_records(data)) {
    require(grid.rows > 0 && grid.columns > 0, "a grid has patches");
    require(grid.patches.size() == std::size_t(grid.rows) * std::size_t(grid.columns),
            "a grid has a patch in each row and column");
    for (const PagePatch& patch : grid.patches)
      for (const glm::dvec2 point : patch.outer)
        require(std::isfinite(point.x) && std::isfinite(point.y), "points are somewhere");
  }
}

}  // namespace gradmesh::fuzz
