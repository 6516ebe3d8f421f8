#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

#include "base/image.h"
#include "metric/block_maxima.h"

namespace gradmesh {

/// Side, in pixels, of the windows whose means are looked at one by one: about the size of an eye
/// or a highlight, which the mean of a whole frame hardly shows.
inline constexpr int local_side = 32;

/// Returns how many rows there are of windows of 32 x 32 pixels inside the map; windows are as wide
/// or high as the map where that is smaller.
inline int local_mean_rows(const Plane& map) {
  return map.samples.empty() ? 0 : map.height - std::min(local_side, map.height) + 1;
}

/// Returns the first pixels of all windows inside a part of the frame.
inline Window local_mean_places(Window part) {
  if (part.empty()) return {};
  return {part.x0, part.y0, std::max(part.x0 + 1, part.x1 - local_side + 1),
          std::max(part.y0 + 1, part.y1 - local_side + 1)};
}

/// Calls `body(x, y, mean)` for every window in the rows from `first` up to but not `end`, row by
/// row; (x, y) is the window's top left pixel. The map may be a part of the frame: the same windows
/// have the same means. `map` holds values of at most 8: those of SSIM, up to 2, times the largest
/// weight.
template <class Body>
void for_each_local_mean(const Plane& map, int first, int end, const Body& body) {
  if (first >= end) return;
  const int width = std::min(local_side, map.width), height = std::min(local_side, map.height);
  // As whole multiples of 2^-40 all running sums are exact: they do not depend on where they began.
  // A double holds such multiples up to 2^13, which is the sum of 32 x 32 values of 8.
  const auto rounded = [](double value) { return (value + 0x1p12) - 0x1p12; };
  std::vector<double> columns(std::size_t(map.width), 0.0);
  for (int y = map.y0 + first; y < map.y0 + end + height - 1; ++y) {
    const float* entering = map.at(map.x0, y);
    for (std::size_t x = 0; x < columns.size(); ++x) columns[x] += rounded(entering[x]);
    const int top = y + 1 - height;
    if (top < map.y0 + first) continue;
    double sum = std::accumulate(columns.begin(), columns.begin() + width, 0.0);
    body(map.x0, top, sum / (width * height));
    for (int x = width; x < map.width; ++x) {
      sum += columns[std::size_t(x)] - columns[std::size_t(x - width)];
      body(map.x0 + x + 1 - width, top, sum / (width * height));
    }
    const float* leaving = map.at(map.x0, top);
    for (std::size_t x = 0; x < columns.size(); ++x) columns[x] -= rounded(leaving[x]);
  }
}

/// Does the same for every window inside the map.
template <class Body>
void for_each_local_mean(const Plane& map, const Body& body) {
  for_each_local_mean(map, 0, local_mean_rows(map), body);
}

/// Adds the mean of every window inside the map, a part of the frame, at the window's first pixel;
/// the part's first row is that of a block. Runs on all threads.
void add_local_means(const Plane& map, BlockMaxima& means);

/// Returns the largest mean of these windows, to 1e-12; 0 for a map without pixels.
double largest_local_mean(const Plane& map);

}  // namespace gradmesh
