#include "reference/paint_picture.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "base/clamped_int.h"
#include "base/parallel.h"
#include "raster/hidden.h"

namespace gradmesh {
namespace {

/// The pixel at a place, 0..size - 1, the one after it, and the share of that.
struct Neighbours {
  Neighbours(double place, int size)
      : first(clamped_int(std::floor(place - 0.5), 0, size - 1)),
        second(std::min(first + 1, size - 1)),
        share(std::clamp(place - 0.5 - first, 0.0, 1.0)) {}

  int first, second;
  double share;
};

/// Samples a picture around the centres of pixels of a frame.
class Sampler {
 public:
  Sampler(const RgbaImage& picture, const Affine& to_pixels)
      : picture_(picture),
        back_(to_pixels.inverse()),
        columns_(samples_along(back_.linear[0])),
        rows_(samples_along(back_.linear[1])) {}

  bool covers(glm::dvec2 centre) const {
    const glm::dvec2 at = back_.point(centre);
    return at.x >= 0 && at.y >= 0 && at.x < picture_.width && at.y < picture_.height;
  }

  /// Returns the mean over the pixel with that centre: the colour times the opacity, in levels, and
  /// the opacity, 0..1.
  glm::dvec4 mean(glm::dvec2 centre) const {
    glm::dvec4 sum(0.0);
    for (int i = 0; i < rows_; ++i)
      for (int j = 0; j < columns_; ++j) {
        const glm::dvec2 off((j + 0.5) / columns_ - 0.5, (i + 0.5) / rows_ - 0.5);
        sum += sample(back_.point(centre + off));
      }
    return sum / (double(rows_) * columns_);
  }

 private:
  /// Returns how many samples a pixel gets along one of its sides, which is that long in the
  /// picture; no more than there are to be read.
  int samples_along(glm::dvec2 side) const {
    // A picture that is painted pixel for pixel is off by no more than this through rounding.
    constexpr double tolerance = 1e-6;
    return clamped_int(std::ceil(glm::length(side) - tolerance), 1,
                       std::max(picture_.width, picture_.height));
  }

  glm::dvec4 pixel(int x, int y) const {
    const double opacity = *picture_.at(x, y, 3) / 255.0;
    return {opacity * *picture_.at(x, y, 0), opacity * *picture_.at(x, y, 1),
            opacity * *picture_.at(x, y, 2), opacity};
  }

  glm::dvec4 sample(glm::dvec2 at) const {
    const Neighbours x(at.x, picture_.width), y(at.y, picture_.height);
    const auto in_row = [&](int row) {
      return glm::mix(pixel(x.first, row), pixel(x.second, row), x.share);
    };
    return glm::mix(in_row(y.first), in_row(y.second), y.share);
  }

  const RgbaImage& picture_;
  /// From pixels of the frame to those of the picture.
  const Affine back_;
  const int columns_, rows_;
};

}  // namespace

void paint_picture(const RgbaImage& picture, const Affine& to_units, const Frame& frame,
                   Painting& painting) {
  const Sampler sampler(picture, frame.to_pixels * to_units);
  const std::uint32_t top = TopFace().with(Face{0}).sample();
  const Window window = painting.window();
  painting.clear(window, frame.ground);
  parallel_for(std::size_t(window.height()), [&](std::size_t i) {
    const int y = window.y0 + int(i);
    for (int x = window.x0; x < window.x1; ++x) {
      const glm::dvec2 centre(x + 0.5, y + 0.5);
      if (!sampler.covers(centre)) continue;
      const glm::dvec4 color = sampler.mean(centre);
      for (int c = 0; c < 3; ++c) {
        const double level = color[c] + (1 - color.a) * frame.ground;
        *painting.image.at(x, y, c) = std::uint8_t(clamped_int(level + 0.5, 0, 255));
      }
      *painting.top.at(x, y) = top;
    }
  });
  if (frame.hidden) frame.hidden->hide(window, frame.ground, painting);
}

}  // namespace gradmesh
