#include "methods/plain/crush.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geom/cross.h"
#include "geom/hermite.h"

namespace gradmesh {
namespace {

constexpr std::size_t along_side = 12;
constexpr double narrow = 0.1;

using Weights = std::array<std::array<double, 4>, along_side + 1>;
using Points = std::array<std::array<glm::dvec2, along_side + 1>, along_side + 1>;

Weights weights_of_lines() {
  Weights weights;
  for (std::size_t i = 0; i <= along_side; ++i)
    weights[i] = hermite_basis(double(i) / double(along_side));
  return weights;
}

Points corners_of_cells(const Patch& patch) {
  static const Weights weights = weights_of_lines();
  Points points{};
  for (std::size_t i = 0; i <= along_side; ++i) {
    std::array<glm::dvec2, 4> line{};
    for (std::size_t n = 0; n < 4; ++n)
      for (std::size_t m = 0; m < 4; ++m) line[n] += weights[i][m] * patch.c[m][n].position;
    for (std::size_t j = 0; j <= along_side; ++j)
      for (std::size_t n = 0; n < 4; ++n) points[i][j] += weights[j][n] * line[n];
  }
  return points;
}

template <class Each>
void for_each_share(const PlainGrid& grid, const Each& each) {
  for (int i = 0; i < grid.rows(); ++i)
    for (int j = 0; j < grid.columns(); ++j) each(narrowest_share(grid.patch(i, j)));
}

}  // namespace

double narrowest_share(const Patch& patch) {
  const Points points = corners_of_cells(patch);
  // Sizes with the sign of how cells are turned.
  double least = INFINITY, most = -INFINITY, sum = 0;
  for (std::size_t i = 0; i < along_side; ++i)
    for (std::size_t j = 0; j < along_side; ++j) {
      const double size =
          cross(points[i + 1][j + 1] - points[i][j], points[i][j + 1] - points[i + 1][j]);
      least = std::min(least, size);
      most = std::max(most, size);
      sum += size;
    }
  if (sum == 0) return 1;
  return (sum > 0 ? least : most) * double(along_side * along_side) / sum;
}

bool is_pinched(const Patch& moved, const Patch& before) {
  constexpr double much = 0.5;
  const double share = narrowest_share(moved);
  if (share >= narrow) return false;
  const double share_before = narrowest_share(before);
  return share_before > 0 && share < much * share_before;
}

Crush::Crush(const PlainGrid& start) : least_share_(narrow) {
  constexpr double kept = 0.2;
  for_each_share(start, [&](double share) {
    if (share > 0) least_share_ = std::min(least_share_, kept * share);
  });
  at_first_ = counted(start);
}

Crush::Count Crush::counted(const PlainGrid& grid) const {
  Count count;
  for_each_share(grid, [&](double share) {
    count.pinched += share < least_share_;
    count.folded += share < 0;
  });
  return count;
}

}  // namespace gradmesh
