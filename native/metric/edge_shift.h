#pragma once

#include <cstdint>
#include <vector>

#include "base/image.h"

namespace gradmesh {

/// Tells by how many pixels the contrasty edges of a picture have moved in another. A mean over the
/// picture hardly sees that a ridge becomes a polygon; a person sees it at once.
///
/// At each pixel the shift is the one across the edge that explains, by least squares over 9 x 9
/// pixels around, the differences of brightness: difference = -slope * shift. It is 0 where nothing
/// is as steep as an edge.
class EdgeShift {
 public:
  /// Only edges count at pixels for which `counts` is 1; it is of the size of the picture.
  EdgeShift(const Image& reference, const Raster<std::uint8_t, 1>& counts);

  /// Returns false if the picture has no edges, so that none can move.
  bool has_edges() const { return !where_.empty(); }

  /// Brings a map of shifts, in pixels and 0 or more, up to date in the pixels to which a change of
  /// the picture in `changed` reaches. `test` and `map` are of the reference's size.
  void update(const Image& test, Window changed, Plane& map) const;

 private:
  Raster<std::int32_t, 1> brightness_;
  /// Slopes of the brightness by x and by y, 0 where it is hardly steep.
  Raster<std::int32_t, 2> slopes_;
  /// The direction across the edge around each pixel, over the sum of the squared slopes that way;
  /// 0 where there is no edge.
  Raster<float, 2> edges_;
  /// The smallest window that holds all edges: most pictures have few, and no others move.
  Window where_;
};

}  // namespace gradmesh
