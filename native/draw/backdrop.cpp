#include "draw/backdrop.h"

namespace gradmesh {

void make_gray(Image& image) {
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const auto [r, g, b] = image.pixel(x, y);
      // Rec. 601 luma.
      const auto luma = std::uint8_t((299 * r + 587 * g + 114 * b) / 1000);
      image.set_pixel(x, y, {luma, luma, luma});
    }
}

PlacedImage backdrop(Image painted, const Frame& frame, const Affine& view, bool gray) {
  if (gray) make_gray(painted);
  // The frame lies straight in the drawing.
  const Affine from_pixels = view * frame.to_pixels.inverse();
  return {std::move(painted), from_pixels.point({0, 0}),
          from_pixels.point({frame.width, frame.height}), 0.35};
}

}  // namespace gradmesh
