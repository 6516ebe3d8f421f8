#include "formats/pdf/grid/welded_points.h"

#include <algorithm>
#include <cmath>

namespace gradmesh {

std::size_t WeldedPoints::CellHash::operator()(const Cell& cell) const {
  // Large odd numbers spread neighbouring cells.
  return std::size_t(std::uint64_t(cell.x) * 0x9E3779B97F4A7C15U ^
                     std::uint64_t(cell.y) * 0xC2B2AE3D27D4EB4FU);
}

WeldedPoints::Cell WeldedPoints::cell_of(glm::dvec2 point) const {
  // Coordinates beyond any page share cells.
  constexpr double most = 1e15;
  const auto at = [&](double x) {
    return static_cast<std::int64_t>(std::clamp(std::floor(x / tolerance_), -most, most));
  };
  return {at(point.x), at(point.y)};
}

int WeldedPoints::number(glm::dvec2 point) {
  const Cell here = cell_of(point);
  int found = -1;
  for (std::int64_t y = here.y - 1; y <= here.y + 1; ++y)
    for (std::int64_t x = here.x - 1; x <= here.x + 1; ++x) {
      const auto cell = cells_.find({x, y});
      if (cell == cells_.end()) continue;
      for (const int n : cell->second) {
        const glm::dvec2 away = points_[std::size_t(n)] - point;
        const bool is_close = std::abs(away.x) <= tolerance_ && std::abs(away.y) <= tolerance_;
        if (is_close && (found < 0 || n < found)) found = n;
      }
    }
  if (found >= 0) return found;
  points_.push_back(point);
  cells_[here].push_back(int(points_.size()) - 1);
  return int(points_.size()) - 1;
}

}  // namespace gradmesh
