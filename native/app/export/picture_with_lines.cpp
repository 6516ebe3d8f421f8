#include "app/export/picture_with_lines.h"

#include <algorithm>

#include "session/mesh_lines.h"

namespace gradmesh {

Image picture_with_lines(const Document& document, const MeshEntry& entry, int resolution) {
  Image image = document.render(entry, resolution, *make_software_rasterizer());
  const Mesh& mesh = document.mesh(entry);
  Canvas canvas(image);
  draw_lines(canvas, mesh, document.frame(entry, mesh, resolution).to_pixels);
  return image;
}

Image beside(const Image& left, const Image& right) {
  constexpr int gap = 8;
  Image both(left.width + gap + right.width, std::max(left.height, right.height), 255);
  copy(left, left.window(), both);
  for (int y = 0; y < right.height; ++y)
    for (int x = 0; x < right.width; ++x)
      for (int c = 0; c < 3; ++c) *both.at(left.width + gap + x, y, c) = *right.at(x, y, c);
  return both;
}

}  // namespace gradmesh
