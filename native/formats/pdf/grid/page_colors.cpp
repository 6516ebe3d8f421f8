#include "formats/pdf/grid/page_colors.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

namespace gradmesh {
namespace {

/// What lies so near to a patch, in points, lies on it.
constexpr double on_patch = 0.01;

/// A place of a patch, and how far it is from the one that was looked for.
struct Found {
  double u = 0.5, v = 0.5;
  double distance = std::numeric_limits<double>::infinity();
};

/// Returns the place of the patch that Newton's method finds nearest from a start.
Found nearest_from(const Patch& patch, glm::dvec2 place, double u, double v) {
  constexpr int steps = 12;
  Found best;
  for (int step = 0; step < steps; ++step) {
    const glm::dvec2 rest = place - patch.at(u, v).position;
    const double distance = glm::length(rest);
    if (distance < best.distance) best = {u, v, distance};
    if (distance <= 1e-3 * on_patch) break;
    const glm::dmat2 slopes(patch.derivative_u(u, v).position, patch.derivative_v(u, v).position);
    const double area = glm::determinant(slopes);
    if (!(std::abs(area) > 1e-12)) break;
    const glm::dvec2 by = glm::inverse(slopes) * rest;
    u = std::clamp(u + by.x, 0.0, 1.0);
    v = std::clamp(v + by.y, 0.0, 1.0);
  }
  return best;
}

Found nearest(const Patch& patch, glm::dvec2 place) {
  Found best;
  for (const glm::dvec2 start :
       {glm::dvec2(0.5, 0.5), {0.1, 0.1}, {0.1, 0.9}, {0.9, 0.1}, {0.9, 0.9}}) {
    const Found found = nearest_from(patch, place, start.x, start.y);
    if (found.distance < best.distance) best = found;
    if (best.distance <= on_patch) break;
  }
  return best;
}

}  // namespace

PageColors::PageColors(const std::vector<PagePatch>& patches) {
  for (const PagePatch& page : patches) {
    Painted& painted = patches_.emplace_back();
    painted.patch = mesh_patch(page);
    for (const glm::dvec2 point : page.outer) painted.box.add(point);
    for (const glm::dvec2 point : page.inner) painted.box.add(point);
  }
}

glm::dvec4 PageColors::at(glm::dvec2 place) const {
  // First what lies there, then what joining patches may have moved away from there.
  constexpr double margins[] = {0, 0.5};
  // Patches of a stranger's file may all have boxes that hold the place.
  constexpr int most = 16;
  const Patch* nearest_patch = &patches_.front().patch;
  Found best{0, 0};
  for (const double margin : margins) {
    int looked_at = 0;
    for (const auto& [patch, box] : patches_) {
      if (place.x < box.low().x - margin || place.y < box.low().y - margin ||
          place.x > box.high().x + margin || place.y > box.high().y + margin)
        continue;
      const Found found = nearest(patch, place);
      if (found.distance < best.distance) {
        best = found;
        nearest_patch = &patch;
      }
      if (best.distance <= on_patch) return nearest_patch->at(best.u, best.v).color;
      if (++looked_at == most) break;
    }
  }
  return nearest_patch->at(best.u, best.v).color;
}

}  // namespace gradmesh
