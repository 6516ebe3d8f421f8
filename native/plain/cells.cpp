#include "plain/cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "geom/hermite.h"

namespace gradmesh {
namespace {

constexpr std::size_t along_side = 12;

/// The sizes of the cells of a patch, times two, with the sign of how they are turned.
struct Cells {
  double least, most, sum;
};

using Weights = std::array<std::array<double, 4>, along_side + 1>;

Weights weights_of_lines() {
  Weights weights;
  for (std::size_t i = 0; i <= along_side; ++i)
    weights[i] = hermite_basis(double(i) / double(along_side));
  return weights;
}

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

Cells cells_of(const Patch& patch) {
  static const Weights weights = weights_of_lines();
  std::array<std::array<glm::dvec2, along_side + 1>, along_side + 1> points{};
  for (std::size_t i = 0; i <= along_side; ++i) {
    std::array<glm::dvec2, 4> line{};
    for (std::size_t n = 0; n < 4; ++n)
      for (std::size_t m = 0; m < 4; ++m) line[n] += weights[i][m] * patch.c[m][n].position;
    for (std::size_t j = 0; j <= along_side; ++j)
      for (std::size_t n = 0; n < 4; ++n) points[i][j] += weights[j][n] * line[n];
  }
  Cells cells{INFINITY, -INFINITY, 0};
  for (std::size_t i = 0; i < along_side; ++i)
    for (std::size_t j = 0; j < along_side; ++j) {
      const double size =
          cross(points[i + 1][j + 1] - points[i][j], points[i][j + 1] - points[i + 1][j]);
      cells.least = std::min(cells.least, size);
      cells.most = std::max(cells.most, size);
      cells.sum += size;
    }
  return cells;
}

}  // namespace

CrushedPatches crushed_patches(const PlainGrid& grid) {
  constexpr double pinched_share = 0.1;
  std::vector<Cells> all;
  double sum = 0;
  for (int i = 0; i < grid.rows(); ++i)
    for (int j = 0; j < grid.columns(); ++j) {
      all.push_back(cells_of(grid.patch(i, j)));
      sum += all.back().sum;
    }
  CrushedPatches crushed;
  for (const Cells& cells : all) {
    const double least = sum > 0 ? cells.least : -cells.most,
                 mean = std::abs(cells.sum) / double(along_side * along_side);
    crushed.pinched += mean > 0 && least < pinched_share * mean;
    crushed.folded += mean > 0 && least < 0;
  }
  return crushed;
}

}  // namespace gradmesh
