#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "base/affine.h"
#include "base/image.h"
#include "mesh/mesh.h"

namespace gradmesh {

/// How something is drawn: its sRGB colour in 0..1, its opacity, and the width of lines in pixels.
struct Ink {
  glm::dvec3 color{0.0};
  double opacity = 1;
  double width = 1;
};

/// Draws smooth lines and marks over a picture. Places are in pixels of the picture's frame; widths
/// and sizes in those that a person tells apart, each of which is `density` of the picture's.
class Canvas {
 public:
  explicit Canvas(Image& image, double density = 1)
      : image_(image), density_(density), cover_(image.window()) {}

  /// Draws lines through points as one drawing: where they cross the opacity is that of one.
  void lines(const std::vector<std::vector<glm::dvec2>>& lines, const Ink& ink);
  /// Draws filled squares, with sides of that size, and a thin edge of the other colour.
  void squares(const std::vector<glm::dvec2>& centers, double size, const Ink& ink,
               const glm::dvec3& edge);
  /// Draws slanted lines, `distance` apart, over the pixels for which `is_inside(x, y)`.
  template <class IsInside>
  void hatch(double distance, const Ink& ink, const IsInside& is_inside) {
    for (int y = 0; y < image_.height; ++y)
      for (int x = 0; x < image_.width; ++x)
        if (is_inside(x, y))
          blend(x, y, ink, stripe(x + y, density_ * distance, density_ * ink.width));
  }

  /// Blends each pixel with the ink that `ink_at(x, y)` points to, if it is not null.
  template <class InkAt>
  void tint(const InkAt& ink_at) {
    for (int y = 0; y < image_.height; ++y)
      for (int x = 0; x < image_.width; ++x)
        if (const Ink* const ink = ink_at(x, y)) blend(x, y, *ink, 1);
  }

 private:
  static double stripe(int at, double distance, double width);
  void segment(glm::dvec2 a, glm::dvec2 b, double width);
  void square(glm::dvec2 center, double half);
  /// Moves a sample by a share of the way, at least 0, to another level.
  static void blend(std::uint8_t& sample, double to, double share) {
    sample = std::uint8_t(sample + share * (to - sample) + 0.5);
  }
  void blend(int x, int y, const Ink& ink, double cover) {
    for (int c = 0; c < 3; ++c) blend(*image_.at(x, y, c), 255 * ink.color[c], ink.opacity * cover);
  }
  /// Blends what the cover has, and clears it.
  void flush(const Ink& ink);

  Image& image_;
  const double density_;
  /// By how much a drawing covers each pixel, 0..1; 0 between drawings.
  Plane cover_;
  /// The pixels that may be covered, some of them more than once.
  struct Run {
    int y, x0, x1;
  };
  std::vector<Run> touched_;
};

/// What makes lines seen that are light, or of another ink, over light pictures.
extern const Ink below_lines;

/// Draws the curves of a mesh over its picture, so that they are seen on light and dark pictures.
void draw_lines(Canvas& canvas, const Mesh& mesh, const Affine& to_pixels);

}  // namespace gradmesh
