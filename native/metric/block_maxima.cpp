#include "metric/block_maxima.h"

namespace gradmesh {

Window BlockMaxima::blocks_of(Window window) const {
  if (window.empty()) return {};
  return {(window.x0 - map_.x0) / side, (window.y0 - map_.y0) / side,
          (window.x1 - 1 - map_.x0) / side + 1, (window.y1 - 1 - map_.y0) / side + 1};
}

Window BlockMaxima::whole_blocks(Window window) const {
  const Window blocks = blocks_of(window.clipped(map_));
  return Window{map_.x0 + blocks.x0 * side, map_.y0 + blocks.y0 * side, map_.x0 + blocks.x1 * side,
                map_.y0 + blocks.y1 * side}
      .clipped(map_);
}

void BlockMaxima::clear(Window whole) { fill(largest_, blocks_of(whole), 0.0); }

void BlockMaxima::add(const Raster<float, 1>& part) {
  const Window window = part.window(), blocks = blocks_of(window);
  for (int y = window.y0; y < window.y1; ++y)
    for (int block = blocks.x0; block < blocks.x1; ++block) {
      const int first = std::max(window.x0, map_.x0 + block * side);
      const int end = std::min(window.x1, map_.x0 + (block + 1) * side);
      const float* const row = part.at(first, y);
      float largest = 0;
      for (int i = 0; i < end - first; ++i) largest = std::max(largest, row[i]);
      add(first, y, double(largest));
    }
}

}  // namespace gradmesh
