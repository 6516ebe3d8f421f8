#include "raster/painter.h"

#include "geom/written.h"
#include "raster/fill.h"
#include "raster/tessellate.h"

namespace gradmesh {
namespace {

Patch painted_patch(const Mesh& mesh, const Frame& frame, Face face) {
  Patch patch = mesh.patch(face);
  if (mesh.color_model() == ColorModel::bilinear)
    patch = as_written(patch, frame.coons_tolerance, frame.masked_opacity);
  return patch;
}

}  // namespace

void Painter::paint(const Mesh& mesh, const Frame& frame, Painting& painting) {
  const Window window = painting.window();
  painting.top.reset(window);
  fill(painting.image, window, std::uint8_t(255));
  fill(painting.top, window, std::uint32_t(0));
  for (const Face f : mesh.faces())
    paint_face(mesh, frame, f, painted_patch(mesh, frame, f), window, painting);
}

void Painter::repaint(const Mesh& mesh, const Frame& frame, const std::vector<Face>& touched,
                      Window within, Painting& painting) {
  within = within.clipped(painting.window());
  if (within.empty() || touched.empty()) return;
  const Window uncovered = clear(touched, within, painting);
  for (const Face f : touched)
    if (std::size_t(f.value) < mesh.face_slots() && mesh[f].alive)
      paint_face(mesh, frame, f, painted_patch(mesh, frame, f), within, painting);
  if (uncovered.empty()) return;
  for (const Face f : mesh.faces())
    if (std::size_t(f.value) >= is_touched_.size() || !is_touched_[f.value])
      paint_face(mesh, frame, f, painted_patch(mesh, frame, f), uncovered, painting);
}

Window Painter::clear(const std::vector<Face>& touched, Window within, Painting& painting) {
  is_touched_.assign(std::size_t(touched.back().value) + 1, false);
  for (const Face f : touched) is_touched_[f.value] = true;
  Window uncovered;
  for (int y = within.y0; y < within.y1; ++y)
    for (int x = within.x0; x < within.x1; ++x) {
      std::uint32_t& sample = *painting.top.at(x, y);
      const TopFace top(sample);
      const Face f = top.face();
      if (!f.valid() || std::size_t(f.value) >= is_touched_.size() || !is_touched_[f.value])
        continue;
      if (top.covers_others()) uncovered = uncovered.united({x, y, x + 1, y + 1});
      sample = 0;
      painting.image.set_pixel(x, y, {255, 255, 255});
    }
  return uncovered;
}

void Painter::paint_face(const Mesh& mesh, const Frame& frame, Face face, const Patch& patch,
                         Window window, Painting& painting) {
  if (pixel_bounds(patch, frame).clipped(window).empty()) return;
  Outlines outlines(mesh, frame);
  for (const Halfedge side : mesh.sides(face)) outlines.prepare(side);
  const PatchColor color(patch, mesh.color_model(), frame.masked_opacity);
  for (const Triangle& triangle : tessellate(mesh, face, patch, frame, outlines))
    fill_triangle(triangle, face, color, window, painting);
}

Painting paint_whole(const Mesh& mesh, const Frame& frame) {
  Painting painting(frame.window());
  paint_whole(mesh, frame, painting);
  return painting;
}

void paint_whole(const Mesh& mesh, const Frame& frame, Painting& painting) {
  Painter().paint(mesh, frame, painting);
}

}  // namespace gradmesh
