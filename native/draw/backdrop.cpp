#include "draw/backdrop.h"

namespace gradmesh {

Picture backdrop(Image painted, const Frame& frame, const Affine& view, bool gray) {
  if (gray)
    for (std::size_t i = 0; i < painted.samples.size(); i += 3) {
      std::uint8_t* rgb = painted.samples.data() + i;
      // Rec. 601 luma.
      rgb[0] = rgb[1] = rgb[2] = std::uint8_t((299 * rgb[0] + 587 * rgb[1] + 114 * rgb[2]) / 1000);
    }
  // The frame lies straight in the drawing.
  const Affine from_pixels = view * frame.to_pixels.inverse();
  return {std::move(painted), from_pixels.point({0, 0}),
          from_pixels.point({frame.width, frame.height}), 0.35};
}

}  // namespace gradmesh
