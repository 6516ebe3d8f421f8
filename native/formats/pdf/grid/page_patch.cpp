#include "formats/pdf/grid/page_patch.h"

namespace gradmesh {

Patch mesh_patch(const PagePatch& page) {
  BezierNet net;
  const auto points = page.net();
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) net[i][j].position = points[i][j];
  net[0][0].color = page.colors[0];
  net[0][3].color = page.colors[1];
  net[3][3].color = page.colors[2];
  net[3][0].color = page.colors[3];
  Patch patch = patch_from_bezier(net);
  make_color_bilinear(patch);
  return patch;
}

void set_zero_twist(PagePatch& patch) {
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t at = 3 * k, count = PagePatch::outer_count;
    patch.inner[k] = patch.outer[at + 1] + patch.outer[(at + count - 1) % count] - patch.outer[at];
  }
}

}  // namespace gradmesh
