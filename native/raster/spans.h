#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/image.h"
#include "raster/outlines.h"

namespace gradmesh {

/// First pixel whose centre is not left of (or above) the grid coordinate.
constexpr int first_pixel(std::int32_t x) {
  constexpr int unit = 1 << subpixel_bits;
  return (x + unit / 2 - 1) >> subpixel_bits;
}

/// Pixels x0 <= x < x1 of a row.
struct Span {
  int y, x0, x1;
};

/// Finds the pixels inside closed polygons, exactly. A centre on an edge is inside where the
/// polygon is on its right, or below it: so neighbours share no pixel and leave none out.
class SpanTracer {
 public:
  /// The spans of `polygon` in the rows from y0 to y1 (exclusive), in rising order. False where it
  /// does not run round each pixel inside once, clockwise (y pointing down) or the other way as
  /// told, or is too winding.
  bool trace(const std::vector<GridPoint>& polygon, bool clockwise, int y0, int y1,
             std::vector<Span>& spans);

 private:
  static constexpr int most_crossings = 8;
  struct Row {
    int count = 0;
    /// In rising order: the first pixel right of an edge, twice, and whether the inside ends there.
    std::array<std::int32_t, most_crossings> crossings;
  };

  bool add_edge(GridPoint a, GridPoint b, bool ends, int y0, int y1);

  std::vector<Row> rows_;
};

}  // namespace gradmesh
