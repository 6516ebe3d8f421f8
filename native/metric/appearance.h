#pragma once

#include <array>
#include <vector>

#include "metric/window_plane.h"

namespace gradmesh {

/// What FLIP compares of two images, per pixel (Andersson et al. 2020, "FLIP: A Difference
/// Evaluator for Alternating Images"). Its colour pipeline gives the colour that an eye resolves
/// from the viewing distance, in CIELab with Hunt's adjustment; its feature pipeline gives the
/// magnitudes of the luminance's first (edge) and second (point) derivative.
template <class T>
struct Appearance {
  T lightness, a, b, edge, point;
};

using AppearanceRow = Appearance<float*>;

/// How far a pixel changes the appearance around it.
inline constexpr int appearance_reach = 10;

/// Computes the appearance of the pixels of `box`, row by row.
class AppearanceFilter {
 public:
  /// Reads the image within `appearance_reach` of `box`, which lies inside the frame.
  AppearanceFilter(const Image& image, Window frame, Window box);

  /// Writes row y of the box.
  void row(int y, const AppearanceRow& out);

 private:
  void colour(int y, const AppearanceRow& out);
  void features(int y, const AppearanceRow& out);

  /// CIE XYZ over white: y, x - y and y - z, which are FLIP's YCxCz but for constant factors.
  WindowPlane<float> luminance_, red_green_, blue_yellow_;
  Window box_;
  using Buffer = std::vector<float>;
  Buffer column_, smooth_column_, sloped_column_, curved_column_;
  Buffer y_, cx_, cz_wide_, cz_narrow_;
  Buffer dx_, dy_;
};

}  // namespace gradmesh
