#include "metric/local_mean.h"

#include <algorithm>
#include <vector>

#include "base/parallel.h"

namespace gradmesh {

double largest_local_mean(const Plane& map) {
  // Each share of the rows reads those of a window's height below it once more.
  constexpr std::size_t least_rows = 64;
  const auto rows = std::size_t(local_mean_rows(map));
  const std::size_t shares = std::max<std::size_t>(1, std::min(thread_count(), rows / least_rows));
  std::vector<double> largest(shares, 0.0);
  parallel_for(shares, [&](std::size_t n) {
    for_each_local_mean(map, int(rows * n / shares), int(rows * (n + 1) / shares),
                        [&](int, int, double mean) { largest[n] = std::max(largest[n], mean); });
  });
  return std::ranges::max(largest);
}

}  // namespace gradmesh
