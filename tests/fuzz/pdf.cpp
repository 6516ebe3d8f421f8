#include <algorithm>

#include "base/error.h"
#include "formats/pdf/page/pdf_file.h"
#include "formats/pdf/page/read_shading.h"
#include "target.h"

namespace gradmesh::fuzz {
namespace {

void check_shading(const PaintedShading& painted) {
  const PageShading read = [&] {
    try {
      return read_shading(painted);
    } catch (const InputError&) {
      return PageShading{0, {ColorSpace::device_gray(), {}}, {}};
    }
  }();
  for (const ShadingPatch& patch : read.patches)
    for (const Components& color : patch.colors) {
      const glm::dvec3 srgb = read.colors.srgb(color);
      for (int c = 0; c < 3; ++c) require(srgb[c] >= 0 && srgb[c] <= 1, "a colour can be shown");
    }
}

}  // namespace

/// A whole document.
void check(std::string_view data) {
  constexpr std::size_t most_pages = 2, most_shadings = 20;
  try {
    const PdfFile file(std::string(data), "document", "");
    for (std::size_t n = 0; n < std::min(most_pages, file.page_count()); ++n) {
      const PageContent page = file.page(n);
      require(page.size.x > 0 && page.size.y > 0, "a page has a size");
      for (std::size_t k = 0; k < std::min(most_shadings, page.painted.size()); ++k) {
        require(page.painted[k].opacity >= 0 && page.painted[k].opacity <= 1, "an opacity is one");
        check_shading(page.painted[k]);
      }
    }
  } catch (const InputError&) {
    return;
  }
}

}  // namespace gradmesh::fuzz
