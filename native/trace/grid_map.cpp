#include "trace/grid_map.h"

#include <algorithm>

#include "base/clamped_int.h"
#include "geom/cross.h"
#include "trace/pixels.h"

namespace gradmesh {
namespace {

bool lies_in(const Quad& quad, glm::dvec2 place) {
  constexpr double last_bits = 1e-9;
  for (std::size_t k = 0; k < 4; ++k) {
    const glm::dvec2 side = quad[(k + 1) & 3] - quad[k];
    if (cross(side, place - quad[k]) < -last_bits) return false;
  }
  return true;
}

}  // namespace

glm::dvec2 place_at(const LineGrid& grid, glm::dvec2 at) {
  const int column = clamped_int(at.x, 0, grid.columns() - 1);
  const int row = clamped_int(at.y, 0, grid.rows() - 1);
  const Quad q = grid.quad(row, column);
  const double u = at.y - row, v = at.x - column;
  return (1 - u) * ((1 - v) * q[0] + v * q[1]) + u * ((1 - v) * q[3] + v * q[2]);
}

std::optional<glm::dvec2> column_and_row(const LineGrid& grid, glm::dvec2 place) {
  for (int row = 0; row < grid.rows(); ++row)
    for (int column = 0; column < grid.columns(); ++column) {
      const Quad quad = grid.quad(row, column);
      if (!lies_in(quad, place)) continue;
      const glm::dvec2 at = QuadMap(quad).parameters(place);
      return glm::dvec2(column + at.y, row + at.x);
    }
  return {};
}

}  // namespace gradmesh
