#include "form/block_outline.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/clamped_int.h"
#include "geom/convex_hull.h"
#include "geom/cross.h"

namespace gradmesh {
namespace {

using Polygon = std::vector<glm::dvec2>;

/// Returns the sides of the block clockwise, each as the half-edges along it.
std::array<std::vector<Halfedge>, 4> outer_sides(const Mesh& mesh, const Rectangle& block) {
  std::array<std::vector<Halfedge>, 4> sides;
  for (int j = 0; j < block.columns; ++j) {
    sides[0].push_back(block.top(0, j));
    sides[2].push_back(mesh.sides(block.top(block.rows - 1, block.columns - 1 - j))[2]);
  }
  for (int i = 0; i < block.rows; ++i) {
    sides[1].push_back(mesh.sides(block.top(i, block.columns - 1))[1]);
    sides[3].push_back(mesh.sides(block.top(block.rows - 1 - i, 0))[3]);
  }
  return sides;
}

double chord_length(const Mesh& mesh, const std::vector<Halfedge>& side) {
  double sum = 0;
  for (const Halfedge h : side) {
    const Cubic<Value> curve = mesh.side_of(h);
    glm::dvec2 last = curve.p0.position;
    for (int i = 1; i <= 4; ++i) {
      const glm::dvec2 p = curve.at(i / 4.0).position;
      sum += glm::length(p - last);
      last = p;
    }
  }
  return sum;
}

/// Returns the number of pieces into which each side of a patch is cut, so that chords are off by
/// at most `flatness`, unless that takes more than 64.
int steps_within(const Mesh& mesh, const std::array<std::vector<Halfedge>, 4>& sides,
                 double flatness) {
  double bend = 0;
  for (const auto& side : sides)
    for (const Halfedge h : side) {
      const Cubic<Value> curve = mesh.side_of(h);
      const glm::dvec2 b0 = curve.p0.position, b1 = curve.bezier1().position;
      const glm::dvec2 b2 = curve.bezier2().position, b3 = curve.p1.position;
      bend = std::max({bend, glm::length(b0 - 2.0 * b1 + b2), glm::length(b1 - 2.0 * b2 + b3)});
    }
  return clamped_int(std::ceil(std::sqrt(6 * bend / (8 * flatness))), 1, 64);
}

Polygon without_repeats(const Polygon& polygon) {
  Polygon result;
  for (const glm::dvec2 p : polygon)
    if (result.empty() || p != result.back()) result.push_back(p);
  while (result.size() > 1 && result.front() == result.back()) result.pop_back();
  return result;
}

/// Moves every edge of a polygon (clockwise on a screen, y down) outwards. Where neighbouring edges
/// come apart they are joined; where they cross, the old corner between them makes sure that the
/// sum of turns around any point near the polygon stays positive.
Polygon offset(const Polygon& polygon, double by) {
  Polygon result;
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    const glm::dvec2 before = polygon[(i + n - 1) % n], p = polygon[i],
                     after = polygon[(i + 1) % n];
    const glm::dvec2 d1 = glm::normalize(p - before), d2 = glm::normalize(after - p);
    const glm::dvec2 n1(d1.y, -d1.x), n2(d2.y, -d2.x);
    const double turn_cosine = glm::dot(d1, d2);
    const glm::dvec2 corner = by / (1 + std::max(turn_cosine, -0.9)) * (n1 + n2);
    if (cross(d1, d2) >= 0) {
      if (turn_cosine > -0.5) {
        result.push_back(p + corner);
      } else {
        result.push_back(p + by * (n1 + d1));
        result.push_back(p + by * (n2 - d2));
      }
    } else {
      const double shorter = std::min(glm::length(p - before), glm::length(after - p));
      const double eaten = by * std::sqrt(std::max(0.0, (1 - turn_cosine) / (1 + turn_cosine)));
      if (turn_cosine > 0 && eaten < 0.5 * shorter) {
        result.push_back(p + corner);
      } else {
        result.push_back(p + by * n1);
        result.push_back(p);
        result.push_back(p + by * n2);
      }
    }
  }
  return result;
}

int winding(const Polygon& polygon, glm::dvec2 p) {
  int turns = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    if ((a.y <= p.y) == (b.y <= p.y)) continue;
    const bool left = cross(b - a, p - a) > 0;
    if (a.y <= p.y && left) ++turns;
    if (a.y > p.y && !left) --turns;
  }
  return turns;
}

Polygon surface_points(const Mesh& mesh, const Rectangle& block) {
  Polygon points;
  for (const Halfedge top : block.tops) {
    const Patch patch = mesh.patch(mesh.face(top));
    for (int i = 0; i <= 8; ++i)
      for (int j = 0; j <= 8; ++j) points.push_back(patch.at(i / 8.0, j / 8.0).position);
  }
  return points;
}

/// Returns true if all points, and all places within about `margin` of them, are inside the
/// polygon.
bool holds(const Polygon& polygon, const Polygon& points, double margin) {
  return std::ranges::all_of(points, [&](glm::dvec2 p) {
    for (int k = 0; k < 8; ++k) {
      const double angle = k * 0.78539816339744831;
      if (winding(polygon, p + margin * glm::dvec2(std::cos(angle), std::sin(angle))) == 0)
        return false;
    }
    return true;
  });
}

}  // namespace

double doubled_area(const std::vector<glm::dvec2>& polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    sum += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  return sum;
}

std::vector<glm::dvec2> block_outline(const Mesh& mesh, const Rectangle& block, int steps) {
  Polygon outline;
  for (const auto& side : outer_sides(mesh, block))
    for (const Halfedge h : side) {
      const Cubic<Value> curve = mesh.side_of(h);
      for (int i = 0; i < steps; ++i) outline.push_back(curve.at(double(i) / steps).position);
    }
  return outline;
}

std::vector<glm::dvec2> grown_outline(const Mesh& mesh, const Rectangle& block, double margin) {
  const auto sides = outer_sides(mesh, block);
  const double across = 0.5 * (chord_length(mesh, sides[0]) + chord_length(mesh, sides[2]));
  const double down = 0.5 * (chord_length(mesh, sides[1]) + chord_length(mesh, sides[3]));
  const double by = std::max(0.5 * std::min(across, down), margin);
  const double flatness = 0.1 * by;

  Polygon outline =
      without_repeats(block_outline(mesh, block, steps_within(mesh, sides, flatness)));
  if (doubled_area(outline) < 0) std::ranges::reverse(outline);
  const Polygon points = surface_points(mesh, block);
  if (outline.size() >= 3) {
    Polygon grown = offset(outline, by + flatness);
    if (holds(grown, points, 0.9 * margin)) return grown;
  }
  // A block that folds over itself: its convex hull holds all of it.
  Polygon hull = convex_hull(points);
  if (hull.size() >= 3) return offset(hull, by + flatness);
  // A block without area, along a line.
  const glm::dvec2 a = hull.front(), b = hull.back();
  return {glm::dvec2(std::min(a.x, b.x) - by, std::min(a.y, b.y) - by),
          glm::dvec2(std::max(a.x, b.x) + by, std::min(a.y, b.y) - by),
          glm::dvec2(std::max(a.x, b.x) + by, std::max(a.y, b.y) + by),
          glm::dvec2(std::min(a.x, b.x) - by, std::max(a.y, b.y) + by)};
}

}  // namespace gradmesh
