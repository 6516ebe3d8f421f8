#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "formats/pdf/grid/page_colors.h"
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

/// The meshes that may stand for the patches of a shading, those that a person would rather have
/// first: the artist's grid with smooth colours and with bilinear ones, with more and more rows and
/// columns, and what has T-junctions. The last one has the patches of the page, all joined, and is
/// never wrong. Which is the first that looks like the page is to be measured: what Illustrator
/// writes has smooth colours, but not all that has patches like its. Finer grids take the most
/// time, so that none is made before one is asked for that may be it.
class MeshForms {
 public:
  /// `own` are the shading's patches, `page` those that show them on the page: the same, or more of
  /// them where colours are not bilinear. `record` is the grid as the artist drew it, where the
  /// document says so.
  MeshForms(const std::vector<ShadingPatch>& own, const std::vector<PagePatch>& page,
            const CornerColors& corners, const std::optional<ArtistsGrid>& record = {});
  /// These alone, at least one, of which the last has the patches of the page.
  explicit MeshForms(std::vector<MeshForm> forms);

  /// Returns the next one; nothing behind the last one.
  std::optional<MeshForm> next();
  /// Returns the last one.
  const MeshForm& page() const { return others_.back(); }

 private:
  /// Grids with more and more patches: the next one, if it is made, and what makes one more.
  struct Grids {
    std::optional<MeshForm> next;
    std::function<std::optional<MeshForm>()> finer;
  };

  void add_grids(const ArtistsGrid& artists, MeshForm::Kind kind);

  std::size_t patches_of_page_ = 0, passed_ = 0;
  std::unique_ptr<const PageColors> colors_;
  std::vector<Grids> grids_;
  /// What comes behind all grids.
  std::vector<MeshForm> others_;
};

}  // namespace gradmesh
