#include "app/export/mesh_picture.h"

#include <algorithm>

#include "app/document/frames.h"
#include "session/canvas.h"

namespace gradmesh {

Image render(const MeshSource& document, const MeshEntry& entry, int resolution,
             const Rasterizer& rasterizer, const MeshSource* other) {
  const Mesh painted = document.mesh(entry);
  return rasterizer.paint(painted, other ? framed_as(*other, document, entry, resolution)
                                         : frame_of(document, entry, painted, resolution));
}

Image render_like_inkscape(const MeshSource& document, const MeshEntry& entry, int resolution,
                           const MeshSource* other) {
  if (document.color_model() == ColorModel::bicubic)
    throw InputError(
        "{0}: Inkscape cannot paint its bicubic colours; gradmesh convert makes an SVG document "
        "of it.",
        document.name());
  return render(document, entry, resolution, *make_cairo_like_rasterizer(), other);
}

Image picture_with_lines(const MeshSource& document, const MeshEntry& entry, int resolution) {
  Image image = render(document, entry, resolution, *make_software_rasterizer());
  const Mesh& mesh = document.mesh(entry);
  Canvas canvas(image);
  draw_lines(canvas, mesh, frame_of(document, entry, mesh, resolution).to_pixels);
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
