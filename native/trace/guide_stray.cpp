#include "trace/guide_stray.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "geom/cross.h"
#include "trace/equations.h"

namespace gradmesh {
namespace {

/// Returns the area between a guide and the straight side from one place on it to another.
double stray_area(const Guide& guide, double from, double to) {
  constexpr int samples = 8;
  const glm::dvec2 start = guide.at(from), side = guide.at(to) - start;
  double sum = 0;
  for (int k = 0; k < samples; ++k)
    sum += std::abs(cross(side, guide.at(std::lerp(from, to, (k + 0.5) / samples)) - start));
  return sum / samples;
}

}  // namespace

double stray_squares(const LineGrid& grid, const TargetPicture& target) {
  if (grid.guides().empty()) return 0;
  constexpr double seen_levels = 20;
  double area = 0;
  for (const Along along : {Along::rows, Along::columns})
    for (int line = 1; line < grid.strips(along); ++line)
      for (int k = 0; k + 1 < grid.points_along(along); ++k) {
        const auto on = [&](int point) {
          return grid.knot(grid.number(along, line, point)).on_guide(along);
        };
        const LineGrid::OnGuide from = on(k), to = on(k + 1);
        if (from.guide >= 0 && from.guide == to.guide)
          area += stray_area(grid.guides()[std::size_t(from.guide)], from.way, to.way);
      }
  const glm::dvec2 scale = pixels_per_unit(grid, target);
  return area * scale.x * scale.y * channels(target) * seen_levels * seen_levels;
}

}  // namespace gradmesh
