#include <algorithm>

#include "raster/painting.h"
#include "raster/rasterizer.h"

namespace gradmesh {
namespace {

class SoftwareRasterizer final : public Rasterizer {
 public:
  void paint(const Mesh& mesh, const Frame& frame, Window window, Image& image) const override {
    window = window.clipped(frame.window());
    if (window.empty()) return;
    Painting painting(window);
    paint_whole(mesh, frame, painting);
    for (int c = 0; c < 3; ++c)
      for (int y = window.y0; y < window.y1; ++y)
        std::copy_n(painting.image.at(window.x0, y, c), window.width(), image.at(window.x0, y, c));
  }
};

}  // namespace

std::unique_ptr<Rasterizer> make_software_rasterizer() {
  return std::make_unique<SoftwareRasterizer>();
}

}  // namespace gradmesh
