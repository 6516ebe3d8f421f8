#include "raster/painting.h"
#include "raster/rasterizer.h"

namespace gradmesh {
namespace {

class SoftwareRasterizer final : public Rasterizer {
 public:
  Image paint(const Mesh& mesh, const Frame& frame) const override {
    return paint_whole(mesh, frame).image;
  }
};

}  // namespace

std::unique_ptr<Rasterizer> make_software_rasterizer() {
  return std::make_unique<SoftwareRasterizer>();
}

}  // namespace gradmesh
