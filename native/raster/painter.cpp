#include "raster/painter.h"

#include <algorithm>
#include <optional>

#include "base/parallel.h"
#include "form/smooth_colors.h"
#include "form/written_patch.h"
#include "raster/hidden.h"
#include "raster/rasterizer.h"

namespace gradmesh {
namespace {

/// Rows that one thread paints at a time, and faces that one thread cuts into triangles at a time.
constexpr int band_height = 64;
constexpr std::size_t share_of_faces = 32;

void hide(const Frame& frame, Window window, Painting& painting) {
  if (frame.hidden) frame.hidden->hide(window, frame.ground, painting);
}

/// A face that is ready to be filled, band by band.
struct ReadyFace {
  Face face;
  std::optional<PatchColor> color;
  FaceShape shape;
};

class SoftwareRasterizer final : public Rasterizer {
 public:
  Image paint(const Mesh& mesh, const Frame& frame) const override {
    return paint_whole(mesh, frame).image;
  }
};

}  // namespace

Patch painted_patch(const Mesh& mesh, const Frame& frame, Face face) {
  Patch patch = mesh.patch(face);
  if (mesh.color_model() == ColorModel::bilinear) patch = as_written(patch, coons_tolerance(frame));
  return patch;
}

void Painter::paint(const Mesh& mesh, const Frame& frame, Painting& painting) {
  if (mesh.is_smooth()) return paint(painted_mesh(mesh), frame, painting);
  painting.clear(painting.window(), frame.ground);
  tessellator_.start(mesh, frame);
  for (const Face f : mesh.faces()) paint_face(mesh, frame, f, painting.window(), painting);
  hide(frame, painting.window(), painting);
}

void Painter::paint_alone(const Mesh& mesh, const Frame& frame, Face face, Window within,
                          Painting& painting) {
  painting.clear(within, frame.ground);
  tessellator_.start(mesh, frame);
  paint_face(mesh, frame, face, within, painting);
  hide(frame, within, painting);
}

void Painter::repaint(const Mesh& mesh, const Frame& frame, const std::vector<Face>& touched,
                      Window within, Painting& painting) {
  // Beside the touched faces others have new colours too.
  if (mesh.is_smooth()) return paint(mesh, frame, painting);
  within = within.clipped(painting.window());
  if (within.empty() || touched.empty()) return;
  tessellator_.start(mesh, frame);
  const Window uncovered = clear(touched, within, frame.ground, painting);
  for (const Face f : touched)
    if (std::size_t(f.value) < mesh.face_slots() && mesh[f].alive)
      paint_face(mesh, frame, f, within, painting);
  if (!uncovered.empty())
    for (const Face f : mesh.faces())
      if (!is_touched(f)) paint_face(mesh, frame, f, uncovered, painting);
  hide(frame, within, painting);
}

Window Painter::clear(const std::vector<Face>& touched, Window within, std::uint8_t ground,
                      Painting& painting) {
  is_touched_.assign(std::size_t(touched.back().value) + 1, false);
  for (const Face f : touched) is_touched_[f.value] = true;
  Window uncovered;
  for_each_run(painting.top, within, [&](Window run, TopFace top) {
    if (!is_touched(top.face())) return;
    if (top.covers_others()) uncovered = uncovered.united(run);
    painting.clear(run, ground);
  });
  return uncovered;
}

void Painter::paint_face(const Mesh& mesh, const Frame& frame, Face face, Window window,
                         Painting& painting) {
  const Patch patch = painted_patch(mesh, frame, face);
  tessellator_.tessellate(face, patch, window, shape_);
  if (shape_.bounds.clipped(window).empty()) return;
  const PatchColor color(patch, mesh.color_model(), frame.masked_opacity, frame.ground);
  fill_face(shape_, face, color, window, parameters_, painting);
}

Painting paint_whole(const Mesh& mesh, const Frame& frame) {
  Painting painting(frame.window());
  paint_whole(mesh, frame, painting);
  return painting;
}

void paint_whole(const Mesh& mesh, const Frame& frame, Painting& painting) {
  if (mesh.is_smooth()) return paint_whole(painted_mesh(mesh), frame, painting);
  if (thread_count() == 1) return Painter().paint(mesh, frame, painting);
  const Window window = painting.window();
  painting.clear(window, frame.ground);
  std::vector<ReadyFace> faces;
  for (const Face f : mesh.faces()) faces.push_back({f, {}, {}});
  const std::size_t shares = (faces.size() + share_of_faces - 1) / share_of_faces;
  parallel_for(shares, [&](std::size_t share) {
    Tessellator tessellator;
    tessellator.start(mesh, frame);
    const std::size_t end = std::min(faces.size(), (share + 1) * share_of_faces);
    for (std::size_t i = share * share_of_faces; i < end; ++i) {
      const Patch patch = painted_patch(mesh, frame, faces[i].face);
      faces[i].color.emplace(patch, mesh.color_model(), frame.masked_opacity, frame.ground);
      tessellator.tessellate(faces[i].face, patch, window, faces[i].shape);
    }
  });
  const int bands = (window.height() + band_height - 1) / band_height;
  parallel_for(std::size_t(bands), [&](std::size_t i) {
    Window band = window;
    band.y0 = window.y0 + int(i) * band_height;
    band.y1 = std::min(window.y1, band.y0 + band_height);
    Parameters parameters;
    for (const ReadyFace& f : faces)
      fill_face(f.shape, f.face, *f.color, band, parameters, painting);
    hide(frame, band, painting);
  });
}

std::unique_ptr<Rasterizer> make_software_rasterizer() {
  return std::make_unique<SoftwareRasterizer>();
}

}  // namespace gradmesh
