#pragma once

#include <array>

#include "metric/appearance_taps.h"
#include "metric/padded_rows.h"

namespace gradmesh {

/// What FLIP compares of two images, per pixel (Andersson et al. 2020, "FLIP: A Difference
/// Evaluator for Alternating Images"). Its colour pipeline gives the colour that an eye resolves
/// from the viewing distance, in CIELab with Hunt's adjustment; its feature pipeline gives the
/// magnitudes of the luminance's first (edge) and second (point) derivative.
template <class Sample>
struct AppearanceRow {
  Sample *lightness, *a, *b, *edge, *point;
};

/// The appearance of the pixels of a window.
class AppearanceRows {
 public:
  void reset(Window window) { planes_.reset(window, 5); }

  /// Samples from one row to the next.
  std::ptrdiff_t stride() const { return planes_.stride(); }
  /// From column x on.
  AppearanceRow<float> row(int x, int y) { return row_of<float>(planes_, x, y); }
  AppearanceRow<const float> row(int x, int y) const { return row_of<const float>(planes_, x, y); }

 private:
  template <class Sample, class Planes>
  static AppearanceRow<Sample> row_of(Planes& planes, int x, int y) {
    return {planes.at(0, x, y), planes.at(1, x, y), planes.at(2, x, y), planes.at(3, x, y),
            planes.at(4, x, y)};
  }

  PaddedRows<float> planes_;
};

/// Linear light of the 256 values of an sRGB sample (IEC 61966-2-1).
const std::array<float, 256>& linear_light();

/// Computes the appearance of an image's pixels, row by row. To be used again, for its memory.
class AppearanceFilter {
 public:
  /// Reads the image within `appearance_reach` of `box`. What of that lies beyond `frame` is taken
  /// for its nearest pixel; the image covers the rest.
  void read(const Image& image, Window frame, Window box);

  /// Writes row y of the box, and some samples of padding behind it.
  void row(int y, const AppearanceRow<float>& out);

 private:
  /// CIE XYZ over white: y, x - y and y - z, which are FLIP's YCxCz but for constant factors.
  PaddedRows<float> opponent_;
  PaddedRows<float> light_, columns_;  ///< One row each.
};

}  // namespace gradmesh
