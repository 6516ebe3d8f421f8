#include "app/picture_with_lines.h"

#include "session/mesh_lines.h"

namespace gradmesh {

Image picture_with_lines(const Document& document, const MeshEntry& entry, int resolution) {
  Image image = document.render(entry, resolution, *make_software_rasterizer());
  const Mesh& mesh = document.mesh(entry);
  Canvas canvas(image);
  draw_lines(canvas, mesh, document.frame(entry, mesh, resolution).to_pixels);
  return image;
}

}  // namespace gradmesh
