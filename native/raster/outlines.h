#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "base/clamped_int.h"
#include "mesh/mesh.h"
#include "raster/frame.h"

namespace gradmesh {

/// Vertices lie on a grid of 1/256 of a pixel, so that which pixels a triangle covers can be
/// decided exactly.
constexpr int subpixel_bits = 8;

/// A point of the grid of 1/256 of a pixel.
struct SubpixelPoint {
  std::int32_t x, y;
  bool operator==(const SubpixelPoint&) const = default;
};

/// Returns the grid point nearest to a position in pixels. The grid ends far outside every frame,
/// so that products of two differences fit into 64 bits.
inline SubpixelPoint snap(glm::dvec2 pixels) {
  const auto to_grid = [](double x) {
    constexpr int farthest = 1000000 << subpixel_bits;
    const double units = x * (1 << subpixel_bits);
    return clamped_int(units < 0 ? units - 0.5 : units + 0.5, -farthest, farthest);
  };
  return {to_grid(pixels.x), to_grid(pixels.y)};
}

/// How far straight pieces may be from a curve, and triangles from the surface, in pixels. Half of
/// the tenth of a pixel that is promised: outlines and inside add up.
constexpr double flatness = 0.05;

/// Where the curves are cut into straight pieces. Both sides of a curve, and all the patches
/// along it, share the same cuts, its T-junctions among them: so neighbours leave no gap.
class Outlines {
 public:
  struct Cut {
    double t;
    SubpixelPoint point;
  };

  /// Starts anew for the mesh as it is now. Keeps the memory, but no cuts of the mesh before.
  void start(const Mesh& mesh, const Frame& frame);
  /// Returns the cuts along a leaf in its own direction and parameter, both ends among them. The
  /// reference is valid until the next call.
  const std::vector<Cut>& along(Halfedge leaf);

 private:
  struct Range {
    std::uint32_t begin = 0, end = 0;
    /// Number of the call of start() for which the range counts.
    std::uint32_t start = 0;
  };

  Range cuts_of(Halfedge curve);
  void add_stems(Halfedge side, bool backwards);

  const Mesh* mesh_ = nullptr;
  const Frame* frame_ = nullptr;
  std::uint32_t starts_ = 0;
  /// The cuts of all curves so far, and the range of each curve in them.
  std::vector<Cut> cuts_;
  std::vector<Range> ranges_;
  std::vector<Cut> along_;
};

}  // namespace gradmesh
