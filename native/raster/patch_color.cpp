#include "raster/patch_color.h"

namespace gradmesh {

PatchColor::PatchColor(const Patch& patch, ColorModel model, bool masked,
                       std::uint8_t shows_through)
    : bilinear(model == ColorModel::bilinear), masked_opacity(masked), ground(shows_through) {
  Bicubic<glm::dvec4> color;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) color[i][j] = patch.c[i][j].color;
  // The first two rows and columns are the same in both forms.
  if (!bilinear) color = change_form(color, powers_of_hermite);
  const int terms = bilinear ? 2 : 4;
  for (int i = 0; i < terms; ++i)
    for (int j = 0; j < terms; ++j) {
      for (int n = 0; n < 4; ++n) channels[n][i][j] = float(color[i][j][n] * (n < 3 ? 255 : 1));
      if (color[i][j].a != (i + j == 0 ? 1.0 : 0.0)) opaque = false;
    }
}

}  // namespace gradmesh
