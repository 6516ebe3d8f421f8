#pragma once

#include <algorithm>

#include "base/image.h"

namespace gradmesh {

/// The largest values that a map has in blocks of 32 x 32 pixels, so that where a part of the map
/// changes the rest need not be looked at again. Values are 0 or more.
class BlockMaxima {
 public:
  BlockMaxima() = default;
  /// Takes the window of the map, in which all values are 0 yet.
  explicit BlockMaxima(Window map)
      : map_(map), largest_((map.width() + side - 1) / side, (map.height() + side - 1) / side) {}

  /// Returns the smallest window of whole blocks, as far as they lie in the map, that holds what
  /// `window` has of the map.
  Window whole_blocks(Window window) const;
  /// Takes the values of whole blocks back to 0.
  void clear(Window whole);
  /// Adds the value of a pixel. Rows of blocks may be filled concurrently.
  void add(int x, int y, double value) {
    double& largest = *largest_.at((x - map_.x0) / side, (y - map_.y0) / side);
    largest = std::max(largest, value);
  }
  /// Adds the values of a part of the map.
  void add(const Raster<float, 1>& part);
  /// Returns the largest value of all; 0 for a map without pixels.
  double largest() const {
    return largest_.samples.empty() ? 0 : std::ranges::max(largest_.samples);
  }

  /// Side of a block in pixels.
  static constexpr int side = 32;

 private:
  /// Returns the blocks that have a pixel of a window inside the map, by their numbers.
  Window blocks_of(Window window) const;

  Window map_;
  Raster<double, 1> largest_;
};

}  // namespace gradmesh
