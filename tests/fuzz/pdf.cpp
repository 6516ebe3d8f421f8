#include <algorithm>

#include "base/error.h"
#include "formats/pdf/grid/mesh_forms.h"
#include "formats/pdf/page/painted_patches.h"
#include "formats/pdf/page/pdf_file.h"
#include "mesh/build.h"
#include "target.h"

namespace gradmesh::fuzz {
namespace {

void check_shading(const PaintedShading& painted, KeptShadings& kept) {
  constexpr std::size_t most_patches = 200;
  PaintedPatches read = painted_patches(painted, kept);
  std::vector<ShadingPatch>& own = read.shading.patches;
  for (const PagePatch& patch : read.patches)
    for (const glm::dvec4& color : patch.colors)
      for (int c = 0; c < 4; ++c) require(color[c] >= 0 && color[c] <= 1, "a colour can be shown");
  if (own.empty() || read.patches.size() > most_patches) return;
  MeshForms forms(own, read.patches, [&](const auto& patches) {
    return corners_in_srgb(patches, read.shading.colors);
  });
  require(forms.page().kind == MeshForm::Kind::page, "the page's own is last");
  while (const std::optional<MeshForm> form = forms.next()) try {
      build_mesh(form->mesh);
    } catch (const InputError&) {
      continue;
    }
}

}  // namespace

/// A whole document.
void check(std::string_view data) {
  constexpr std::size_t most_pages = 2, most_shadings = 20;
  try {
    const PdfFile file(std::string(data), "document", "");
    KeptShadings kept;
    for (std::size_t n = 0; n < std::min(most_pages, file.page_count()); ++n) {
      const PageContent page = file.page(n);
      require(page.size.x > 0 && page.size.y > 0, "a page has a size");
      for (std::size_t k = 0; k < std::min(most_shadings, page.painted.size()); ++k) {
        require(page.painted[k].opacity >= 0 && page.painted[k].opacity <= 1, "an opacity is one");
        try {
          check_shading(page.painted[k], kept);
        } catch (const InputError&) {
          continue;
        }
      }
    }
  } catch (const InputError&) {
    return;
  }
}

}  // namespace gradmesh::fuzz
