#include "device/egl_rasterizer.h"

#include <algorithm>

#include "device/tile_painter.h"
#include "device/use.h"
#include "form/smooth_colors.h"
#include "raster/hidden.h"

namespace gradmesh {
namespace {

/// Pixels of the frame that are painted at once, in whole rows.
constexpr int most_pixels = 1 << 22;

class EglRasterizer final : public Rasterizer {
 public:
  explicit EglRasterizer(std::shared_ptr<Device> device) : device_(std::move(device)) {
    const Device::Use use(*device_);
    painter_ = std::make_unique<TilePainter>(use);
    use.check();
  }
  ~EglRasterizer() override { release_on(*device_, painter_); }

  Image paint(const Mesh& mesh, const Frame& frame) const override {
    if (mesh.is_smooth()) return paint(painted_mesh(mesh), frame);
    Painting painting(frame.window());
    const int rows = std::max(1, most_pixels / frame.width);
    for (int y = 0; y < frame.height; y += rows)
      paint_band(mesh, frame, {0, y, frame.width, std::min(y + rows, frame.height)},
                 painting.image);
    if (frame.hidden) frame.hidden->hide(frame.window(), frame.ground, painting);
    return std::move(painting.image);
  }

 private:
  void paint_band(const Mesh& mesh, const Frame& frame, Window band, Image& image) const {
    EditTiler tiler;
    EditTile tile;
    tiler.make_whole(mesh, frame, band, tile);
    Atlas atlas;
    atlas.add(tile, {});
    std::vector<std::uint32_t> colors(std::size_t(band.width()) * std::size_t(band.height()));
    {
      const Device::Use use(*device_);
      painter_->paint(atlas, nullptr);
      painter_->colors().read(std::span(colors));
      use.check();
    }
    for (int c = 0; c < 3; ++c)
      std::ranges::transform(colors, image.at(0, band.y0, c),
                             [&](std::uint32_t color) { return std::uint8_t(color >> (8 * c)); });
  }

  std::shared_ptr<Device> device_;
  std::unique_ptr<TilePainter> painter_;
};

}  // namespace

std::unique_ptr<Rasterizer> make_egl_rasterizer(std::shared_ptr<Device> device) {
  return std::make_unique<EglRasterizer>(std::move(device));
}

}  // namespace gradmesh
