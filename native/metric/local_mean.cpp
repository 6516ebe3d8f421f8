#include "metric/local_mean.h"

#include <algorithm>

#include "base/parallel.h"

namespace gradmesh {

void add_local_means(const Plane& map, BlockMaxima& means) {
  // Each share reads the rows of a window's height below it once more, so it is not too small; and
  // it has whole rows of blocks, which no other one has.
  constexpr int least_rows = 2 * BlockMaxima::side;
  const int rows = local_mean_rows(map), most = (rows + least_rows - 1) / least_rows;
  const int shares = std::min(int(thread_count()), most);
  parallel_for(std::size_t(shares), [&](std::size_t n) {
    const int first = most * int(n) / shares * least_rows,
              end = std::min(rows, most * (int(n) + 1) / shares * least_rows);
    for_each_local_mean(map, first, end, [&](int x, int y, double mean) { means.add(x, y, mean); });
  });
}

double largest_local_mean(const Plane& map) {
  BlockMaxima means(local_mean_places(map.window()));
  add_local_means(map, means);
  return means.largest();
}

}  // namespace gradmesh
