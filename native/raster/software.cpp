#include <algorithm>

#include "base/parallel.h"
#include "geom/written.h"
#include "raster/fill.h"
#include "raster/rasterizer.h"
#include "raster/tessellate.h"

namespace gradmesh {
namespace {

struct PaintedFace {
  Face face;
  Patch patch;
  Window bounds;
  std::vector<Triangle> triangles;
};

/// Rows that one thread paints at a time.
constexpr int band_height = 32;

class SoftwareRasterizer final : public Rasterizer {
 public:
  void paint(const Mesh& mesh, const Frame& frame, Window window, Image& image) const override {
    window = window.clipped(frame.window());
    if (window.empty()) return;
    std::vector<PaintedFace> faces = faces_in(mesh, frame, window);

    Outlines outlines(mesh, frame);
    for (const PaintedFace& f : faces)
      for (const Halfedge side : mesh.sides(f.face)) outlines.prepare(side);
    parallel_for(faces.size(), [&](std::size_t i) {
      faces[i].triangles = tessellate(mesh, faces[i].face, faces[i].patch, frame, outlines);
    });

    const int bands = (window.height() + band_height - 1) / band_height;
    parallel_for(std::size_t(bands), [&](std::size_t i) {
      Window band = window;
      band.y0 = window.y0 + int(i) * band_height;
      band.y1 = std::min(window.y1, band.y0 + band_height);
      paint_band(faces, mesh.color_model(), frame, band, image);
    });
  }

 private:
  static std::vector<PaintedFace> faces_in(const Mesh& mesh, const Frame& frame, Window window) {
    std::vector<PaintedFace> faces;
    for (const Face f : mesh.faces()) {
      Patch patch = mesh.patch(f);
      if (mesh.color_model() == ColorModel::bilinear)
        patch = as_written(patch, frame.coons_tolerance, frame.masked_opacity);
      const Window bounds = pixel_bounds(patch, frame);
      if (!bounds.clipped(window).empty()) faces.push_back({f, patch, bounds, {}});
    }
    return faces;
  }

  static void paint_band(const std::vector<PaintedFace>& faces, ColorModel model,
                         const Frame& frame, Window band, Image& image) {
    fill(image, band, std::uint8_t(255));
    for (const PaintedFace& f : faces) {
      if (f.bounds.clipped(band).empty()) continue;
      const PatchColor color(f.patch, model, frame.masked_opacity);
      for (const Triangle& triangle : f.triangles) fill_triangle(triangle, color, band, image);
    }
  }
};

}  // namespace

std::unique_ptr<Rasterizer> make_software_rasterizer() {
  return std::make_unique<SoftwareRasterizer>();
}

}  // namespace gradmesh
