#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/image.h"
#include "raster/outlines.h"

namespace gradmesh {

/// Returns the first pixel whose centre is not left of (or above) the grid coordinate.
constexpr int first_pixel(std::int32_t x) {
  constexpr int unit = 1 << subpixel_bits;
  return (x + unit / 2 - 1) >> subpixel_bits;
}

/// Pixels x0 <= x < x1 of a row.
struct Span {
  int y, x0, x1;
};

/// Finds the pixels inside closed polygons, exactly. A centre on an edge is inside if the polygon
/// is on its right, or below it: so neighbours share no pixel and leave none out.
class SpanTracer {
 public:
  /// Finds the spans of `polygon` in the rows from y0 to y1 (exclusive), in rising order. Returns
  /// false if the polygon does not run exactly once round each pixel inside, in the sense that
  /// `clockwise` says (y pointing down), or if it has more than `most_crossings` crossings in a
  /// row.
  bool trace(const std::vector<SubpixelPoint>& polygon, bool clockwise, int y0, int y1,
             std::vector<Span>& spans);

 private:
  static constexpr int most_crossings = 8;
  struct Row {
    int count = 0;
    /// For each edge twice the first pixel on its right, plus 1 if the inside ends there; in rising
    /// order.
    std::array<std::int32_t, most_crossings> crossings;
  };

  bool add_edge(SubpixelPoint a, SubpixelPoint b, bool ends, int y0, int y1);

  std::vector<Row> rows_;
};

}  // namespace gradmesh
