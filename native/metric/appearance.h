#pragma once

#include <array>
#include <type_traits>

#include "metric/appearance_taps.h"
#include "metric/padded_rows.h"

namespace gradmesh {

/// The quantities in which FLIP compares two images, per pixel (Andersson et al. 2020, "FLIP: A
/// Difference Evaluator for Alternating Images"). Its colour pipeline gives the colour that an eye
/// resolves from the viewing distance, in CIELab with Hunt's adjustment; its feature pipeline gives
/// the magnitudes of the luminance's first (edge) and second (point) derivative.
template <class Sample>
struct AppearanceRow {
  Sample *lightness, *a, *b, *edge, *point;
};

inline constexpr int appearance_planes = 5;

/// Returns row y, from column x on, of planes that hold the appearance of the pixels of a window.
template <class Planes>
auto appearance_row(Planes& planes, int x, int y) {
  using Sample = std::remove_pointer_t<decltype(planes.at(0, x, y))>;
  return AppearanceRow<Sample>{planes.at(0, x, y), planes.at(1, x, y), planes.at(2, x, y),
                               planes.at(3, x, y), planes.at(4, x, y)};
}

/// Returns the linear light of the 256 values of an sRGB sample (IEC 61966-2-1).
const std::array<float, 256>& linear_light();

/// Computes the appearance of an image's pixels, row by row. A filter that is used again uses its
/// memory again.
class AppearanceFilter {
 public:
  /// Reads the image within `appearance_reach` of `box`. Places beyond `frame` take the value of
  /// the nearest pixel inside; the image covers the others.
  void read(const Image& image, Window frame, Window box);

  /// Writes row y of the box, and some samples of padding behind it.
  void row(int y, const AppearanceRow<float>& out);

 private:
  /// CIE XYZ over white: y, x - y and y - z, which are FLIP's YCxCz but for constant factors.
  PaddedRows<float> opponent_;
  PaddedRows<float> light_, columns_;  ///< Of one row each.
};

}  // namespace gradmesh
