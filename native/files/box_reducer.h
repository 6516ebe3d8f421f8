#pragma once

#include <cstdint>
#include <vector>

#include "base/image.h"

namespace gradmesh {

/// Reduces a picture while its rows come, so that it is never held as a whole. Each pixel of the
/// result is the average over the rectangle that it covers, to the fraction of a pixel; colours
/// count by their opacity.
class BoxReducer {
 public:
  BoxReducer() = default;
  /// For a picture of this size, neither side of which is 0: its longer side becomes `longest`
  /// pixels, or stays where it is shorter.
  BoxReducer(int width, int height, int longest);

  /// Takes the next row, from the top: red, green, blue and opacity of each pixel, to 65535.
  void add_row(const std::uint16_t* rgba);
  /// Whether all rows have come.
  bool is_whole() const { return rows_ == height_; }
  /// Where all rows have come, the picture. Colours of what cannot be seen are 0.
  const RgbaImage& image() const { return image_; }

 private:
  void sum_up(const std::uint16_t* rgba);
  void finish_row(int y);

  int width_ = 0, height_ = 0, rows_ = 0;
  RgbaImage image_;
  // Of a row of the result: sums of the colours, multiplied by opacity, and of the opacities. All
  // terms are whole numbers: to 2^53 the sums are exact.
  std::vector<double> row_, total_;
};

}  // namespace gradmesh
