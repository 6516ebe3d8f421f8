#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "formats/pdf/grid/page_patch.h"
#include "formats/pdf/grid/smooth_grid.h"
#include "formats/pdf/shading/read_patches.h"
#include "mesh/parts.h"

namespace gradmesh {

/// A mesh that may stand for the patches of a shading.
struct MeshForm {
  /// In page coordinates; the colours of corners are multiples of 1 / 255.
  MeshParts mesh;
  /// How it is more than the patches of the page.
  enum class Kind {
    page,     ///< it is not
    joined,   ///< by patches that were joined to larger ones
    artists,  ///< by a grid of those that were halved for the page, with the artist's smooth
              ///< colours
    record,   ///< likewise, by the grid that the document holds beside the page
  };
  Kind kind = Kind::page;
};

/// Gives patches of a shading the colours of their corners, one patch for each.
using CornerColors = std::function<std::vector<PagePatch>(const std::vector<ShadingPatch>&)>;

/// Returns the patches of a shading as they are on the page, in painting order, joined to nothing.
MeshParts loose_mesh(const std::vector<PagePatch>& patches);

/// Returns the meshes that may stand for the patches of a shading, those that a person would rather
/// have first: the artist's grid with smooth colours and with bilinear ones, with more and more
/// rows and columns, and what has T-junctions. The last one has the patches of the page, all
/// joined, and is never wrong. Which is the first that looks like the page is to be measured: what
/// Illustrator writes has smooth colours, but not all that has patches like its.
///
/// `own` are the shading's patches, `page` those that show them on the page: the same, or more of
/// them where colours are not bilinear. `record` is the grid as the artist drew it, where the
/// document says so.
std::vector<MeshForm> mesh_forms(const std::vector<ShadingPatch>& own,
                                 const std::vector<PagePatch>& page, const CornerColors& corners,
                                 const std::optional<ArtistsGrid>& record = {});

}  // namespace gradmesh
