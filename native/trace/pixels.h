#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec2.hpp>

#include "base/clamped_int.h"
#include "geom/cross.h"

namespace gradmesh {

/// The corners of a convex patch with straight sides, clockwise from where u and v are 0;
/// u runs from the first corner to the last, v from the first to the second (geom/patch.h).
using Quad = std::array<glm::dvec2, 4>;

/// Where a straight side crosses the middle line of a row: the same number from both of the patches
/// beside it, so that each pixel belongs to one.
inline double crossing(glm::dvec2 a, glm::dvec2 b, double y) {
  if (a.y > b.y || (a.y == b.y && a.x > b.x)) std::swap(a, b);
  return a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y));
}

/// The map of a patch with straight sides from u and v to pixels, and back.
class QuadMap {
 public:
  explicit QuadMap(const Quad& q)
      : start_(q[0]),
        along_v_(q[1] - q[0]),
        along_u_(q[3] - q[0]),
        both_(q[0] - q[1] + q[2] - q[3]) {
    square_ = cross(along_v_, both_);
    linear_ = cross(along_v_, along_u_);
  }

  glm::dvec2 by_u(double v) const { return along_u_ + v * both_; }
  glm::dvec2 by_v(double u) const { return along_v_ + u * both_; }

  /// Returns u and v of a place in the patch: of the two places of which the map makes it, the one
  /// in the patch.
  glm::dvec2 parameters(glm::dvec2 place) const {
    // From r = v * V + u * (U + v * B) follows, as the last term has no cross product with its own
    // direction, (V x B) v^2 + (V x U - r x B) v - r x U = 0.
    const glm::dvec2 r = place - start_;
    const double at = cross(r, along_u_), slope = linear_ - cross(r, both_);
    const double below = slope + std::sqrt(std::max(0.0, slope * slope + 4 * square_ * at));
    const double v = std::clamp(below != 0 ? 2 * at / below : 0.5, 0.0, 1.0);
    const glm::dvec2 way = by_u(v), rest = r - v * along_v_;
    const double u = std::abs(way.x) > std::abs(way.y) ? rest.x / way.x : rest.y / way.y;
    return {std::isfinite(u) ? std::clamp(u, 0.0, 1.0) : 0.5, v};
  }

 private:
  glm::dvec2 start_, along_v_, along_u_, both_;
  double square_, linear_;
};

/// Calls `f(x, y)` for the pixels of a picture whose point (`point` of the pixel's way from its
/// upper left corner, in both directions) lies in the patch.
template <class F>
void for_each_pixel(const Quad& quad, int width, int height, double point, const F& f) {
  const auto [low, high] = std::minmax({quad[0].y, quad[1].y, quad[2].y, quad[3].y});
  const int first = clamped_int(std::ceil(low - point), 0, height);
  const int last = clamped_int(std::floor(high - point), -1, height - 1);
  for (int row = first; row <= last; ++row) {
    const double y = row + point;
    double left = width, right = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const glm::dvec2 a = quad[k], b = quad[(k + 1) & 3];
      if ((a.y <= y) == (b.y <= y)) continue;
      const double x = crossing(a, b, y);
      left = std::min(left, x);
      right = std::max(right, x);
    }
    const int begin = clamped_int(std::ceil(left - point), 0, width);
    const int end = clamped_int(std::ceil(right - point), 0, width);
    for (int column = begin; column < end; ++column) f(column, row);
  }
}

}  // namespace gradmesh
