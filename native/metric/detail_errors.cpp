#include "metric/detail_errors.h"

#include <algorithm>
#include <vector>

namespace gradmesh {
namespace {

constexpr int before = detail_side / 2, after = detail_side - before - 1;

}  // namespace

void update_detail_errors(const Plane& errors, const Raster<std::uint8_t, 1>& counts,
                          Window changed, Plane& means) {
  const Window frame = counts.window(), window = Window{changed.x0 - after, changed.y0 - after,
                                                        changed.x1 + before, changed.y1 + before}
                                                     .clipped(frame);
  if (window.empty()) return;
  const auto width = std::size_t(window.width());
  // The sums over four pixels of a row, of the last four rows.
  std::vector<float> counted(width + detail_side - 1), across(width * detail_side, 0.0F);
  for (int y = window.y0 - before; y < window.y1 + after; ++y) {
    float* const sums = across.data() + std::size_t((y + detail_side) % detail_side) * width;
    std::ranges::fill(counted, 0.0F);
    if (y >= frame.y0 && y < frame.y1) {
      const int x0 = std::max(window.x0 - before, frame.x0),
                x1 = std::min(window.x1 + after, frame.x1);
      const float* const error = errors.at(x0, y);
      const std::uint8_t* const count = counts.at(x0, y);
      float* const to = counted.data() + (x0 - (window.x0 - before));
      for (int i = 0; i < x1 - x0; ++i) to[i] = count[i] ? error[i] : 0.0F;
    }
    for (std::size_t i = 0; i < width; ++i)
      sums[i] = (counted[i] + counted[i + 1]) + (counted[i + 2] + counted[i + 3]);
    const int middle = y - after;
    if (middle < window.y0) continue;
    float* const mean = means.at(window.x0, middle);
    const auto row = [&](int v) {
      return across.data() + std::size_t((v + detail_side) % detail_side) * width;
    };
    const float *a = row(middle - 2), *b = row(middle - 1), *c = row(middle), *d = row(middle + 1);
    for (std::size_t i = 0; i < width; ++i)
      mean[i] = ((a[i] + b[i]) + (c[i] + d[i])) * (1.0F / (detail_side * detail_side));
  }
}

}  // namespace gradmesh
