#pragma once

#include <algorithm>
#include <vector>

#include "raster/tessellate.h"

namespace gradmesh {

/// How many samples beyond its end a row of Parameters may be read and written.
constexpr std::size_t row_padding = 16;

/// Memory for Newton's method at some pixels of each row.
struct Knots {
  /// Place of the knot in pixels, counted from Refinement::x and y.
  std::vector<float> x, y;
  std::vector<float> u, v;
  /// Change of u and v from a pixel to the next.
  std::vector<float> du, dv;
  /// Pixels to the next knot of the row.
  std::vector<float> length;
  /// 1 where interpolation up to the next knot is near enough, else 0.
  std::vector<float> near;

  void resize(std::size_t size) {
    for (std::vector<float>* values : {&x, &y, &u, &v, &du, &dv, &length, &near})
      values->resize(std::max(values->size(), size));
  }
};

/// The parameters on a patch of the centres of pixels. Rows have room for `row_padding` more
/// samples at their ends, whose values may be anything.
struct Parameters {
  Window window;
  std::size_t stride = 0;
  /// u is `not_covered` where the patch does not cover the pixel; then v may be anything.
  std::vector<float> u, v;
  struct Extent {
    int x0, x1;
  };
  /// For each row the range outside of which no pixel is covered.
  std::vector<Extent> extents;
  Knots knots;

  static constexpr float not_covered = -1;

  std::size_t offset(int x, int y) const {
    return std::size_t(y - window.y0) * stride + std::size_t(x - window.x0);
  }
};

/// Finds the parameters of each pixel of `window` that the shape covers: those whose centres its
/// triangles cover. A centre on an edge belongs to exactly one of the two triangles beside it.
/// Where a patch folds over itself the larger v, then the larger u, lies on top, as the
/// documentation of cairo's mesh patterns and PDF 32000-1, 8.7.4.5.7, have it. The parameters of a
/// pixel do not depend on the window.
void find_parameters(const FaceShape& shape, Window window, Parameters& parameters);

/// Marks the pixels that the triangles of `shape` cover, with parameters interpolated linearly over
/// each triangle. The caller has set the window of `parameters` and marked all of its pixels as not
/// covered.
void cover(const FaceShape& shape, Parameters& parameters);

/// Finds the parameters of the pixels of a traced shape. The caller has set the window of
/// `parameters` and marked all of its pixels as not covered.
void invert(const FaceShape& shape, Parameters& parameters);

}  // namespace gradmesh
