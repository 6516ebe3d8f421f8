#include "draw/backdrop.h"

namespace gradmesh {

Picture backdrop(Image painted, const Frame& frame, const Affine& view, bool gray) {
  if (gray)
    for (int y = 0; y < painted.height; ++y)
      for (int x = 0; x < painted.width; ++x) {
        const auto [r, g, b] = painted.pixel(x, y);
        // Rec. 601 luma.
        const auto luma = std::uint8_t((299 * r + 587 * g + 114 * b) / 1000);
        painted.set_pixel(x, y, {luma, luma, luma});
      }
  // The frame lies straight in the drawing.
  const Affine from_pixels = view * frame.to_pixels.inverse();
  return {std::move(painted), from_pixels.point({0, 0}),
          from_pixels.point({frame.width, frame.height}), 0.35};
}

}  // namespace gradmesh
