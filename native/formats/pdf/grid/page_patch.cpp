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

}  // namespace gradmesh
