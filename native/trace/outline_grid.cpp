#include "trace/outline_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "base/clamped_int.h"

namespace gradmesh {
namespace {

using Polygon = std::vector<glm::dvec2>;

double wedge(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

double area(const Polygon& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    twice += wedge(polygon[i], polygon[(i + 1) % polygon.size()]);
  return twice / 2;
}

/// A closed curve as places at even distances along it, clockwise on a page whose y runs down.
class Ring {
 public:
  explicit Ring(Polygon polygon) {
    if (area(polygon) < 0) std::ranges::reverse(polygon);
    std::vector<double> ends;
    double length = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
      ends.push_back(length += glm::distance(polygon[i], polygon[(i + 1) % polygon.size()]));
    std::size_t side = 0;
    for (int k = 0; k < count; ++k) {
      const double way = length * k / count;
      while (side + 1 < ends.size() && ends[side] < way) ++side;
      const glm::dvec2 a = polygon[side], b = polygon[(side + 1) % polygon.size()];
      const double here = glm::distance(a, b);
      const double share = here > 0 ? 1 - std::clamp((ends[side] - way) / here, 0.0, 1.0) : 0;
      places_.push_back(a + share * (b - a));
    }
  }

  static constexpr int count = 1440;

  /// The number of a place counts on around the ring.
  glm::dvec2 at(int k) const { return places_[std::size_t(((k % count) + count) % count)]; }

  /// Returns by how much the ring turns about a place, in radians, 0 where it is straight.
  double turn(int k) const {
    constexpr int near = count / 60;
    const glm::dvec2 before = at(k) - at(k - near), after = at(k + near) - at(k);
    return std::abs(std::atan2(wedge(before, after), glm::dot(before, after)));
  }

 private:
  Polygon places_;
};

/// Returns the numbers of the four corners in a ring, clockwise from the upper left one.
std::optional<std::array<int, 4>> corners_of(const Ring& ring) {
  constexpr int reach = Ring::count / 12;
  constexpr double sharp = 0.6;
  glm::dvec2 low(std::numeric_limits<double>::infinity()), high = -low;
  for (int k = 0; k < Ring::count; ++k) {
    low = glm::min(low, ring.at(k));
    high = glm::max(high, ring.at(k));
  }
  constexpr glm::dvec2 diagonals[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  std::array<int, 4> corners{};
  for (std::size_t i = 0; i < 4; ++i) {
    const glm::dvec2 way = diagonals[i] / (high - low);
    const auto outwards = [&](int k) { return glm::dot(way, ring.at(k)); };
    int farthest = 0;
    for (int k = 1; k < Ring::count; ++k)
      if (outwards(k) > outwards(farthest)) farthest = k;
    int sharpest = farthest;
    for (int k = farthest - reach; k <= farthest + reach; ++k)
      if (ring.turn(k) > std::max(sharp, ring.turn(sharpest) + 1e-9)) sharpest = k;
    corners[i] = (sharpest + Ring::count) % Ring::count;
  }
  // Each counts on from the one before, and all within a turn.
  for (std::size_t i = 1; i < 4; ++i) {
    if (corners[i] <= corners[i - 1]) corners[i] += Ring::count;
    if (corners[i] >= corners[0] + Ring::count) return {};
  }
  return corners;
}

/// A straight line beyond which a piece of the outline does not reach.
struct Side {
  glm::dvec2 outward;
  double reach;

  double lacks(glm::dvec2 p) const { return reach - glm::dot(outward, p); }
};

/// Returns the side around the ring from one place to another.
Side side_around(const Ring& ring, int from, int to) {
  constexpr double margin = 1.5;
  const glm::dvec2 way = ring.at(to) - ring.at(from);
  const glm::dvec2 outward = glm::dvec2(way.y, -way.x) / std::max(glm::length(way), 1e-9);
  double reach = glm::dot(outward, ring.at(from));
  for (int k = from; k <= to; ++k) reach = std::max(reach, glm::dot(outward, ring.at(k)));
  return {outward, reach + margin};
}

/// Returns the place nearest to `p` that is beyond neither side.
glm::dvec2 between(const Side& a, const Side& b, glm::dvec2 p) {
  constexpr double last_bits = 1e-9;
  const glm::dvec2 to_a = p + std::max(0.0, a.lacks(p)) * a.outward;
  if (b.lacks(to_a) <= last_bits) return to_a;
  const glm::dvec2 to_b = p + std::max(0.0, b.lacks(p)) * b.outward;
  if (a.lacks(to_b) <= last_bits) return to_b;
  const double parallel = wedge(a.outward, b.outward);
  return glm::dvec2(a.reach * b.outward.y - b.reach * a.outward.y,
                    b.reach * a.outward.x - a.reach * b.outward.x) /
         parallel;
}

/// Returns the polygon around a ring with so many points on its four sides, from the upper left.
Polygon polygon_around(const Ring& ring, const std::array<int, 4>& corners, int rows, int columns) {
  std::vector<int> numbers;
  for (std::size_t i = 0; i < 4; ++i) {
    const int from = corners[i], to = i < 3 ? corners[i + 1] : corners[0] + Ring::count;
    const int pieces = i % 2 == 0 ? columns : rows;
    for (int k = 0; k < pieces; ++k)
      numbers.push_back(from + clamped_int(double(to - from) * k / pieces, 0, Ring::count));
  }
  std::vector<Side> sides;
  for (std::size_t k = 0; k < numbers.size(); ++k)
    sides.push_back(side_around(
        ring, numbers[k], k + 1 < numbers.size() ? numbers[k + 1] : numbers.front() + Ring::count));
  Polygon polygon;
  for (std::size_t k = 0; k < numbers.size(); ++k)
    polygon.push_back(
        between(sides[(k + sides.size() - 1) % sides.size()], sides[k], ring.at(numbers[k])));
  return polygon;
}

/// Returns the points of a grid whose border is the polygon, row by row: between its sides as of a
/// Coons patch.
Polygon grid_inside(const Polygon& border, int rows, int columns) {
  const auto at = [&](int k) { return border[std::size_t(k) % border.size()]; };
  const auto top = [&](int j) { return at(j); };
  const auto right = [&](int i) { return at(columns + i); };
  const auto bottom = [&](int j) { return at(columns + rows + columns - j); };
  const auto left = [&](int i) { return at(2 * (columns + rows) - i); };
  Polygon places;
  for (int i = 0; i <= rows; ++i)
    for (int j = 0; j <= columns; ++j) {
      const double u = double(j) / columns, v = double(i) / rows;
      const glm::dvec2 corners = (1 - u) * ((1 - v) * top(0) + v * bottom(0)) +
                                 u * ((1 - v) * top(columns) + v * bottom(columns));
      places.push_back((1 - v) * top(j) + v * bottom(j) + (1 - u) * left(i) + u * right(i) -
                       corners);
    }
  return places;
}

bool lies_in(const Ring& ring, const Polygon& polygon) {
  for (int k = 0; k < Ring::count; ++k)
    if (!contains({{polygon}}, ring.at(k))) return false;
  return true;
}

}  // namespace

std::optional<LineGrid> outline_grid(const Outline& outline, int rows, int columns,
                                     glm::dvec2 size) {
  const auto largest = std::ranges::max_element(
      outline, {}, [](const Polygon& polygon) { return std::abs(area(polygon)); });
  if (largest == outline.end() || area(*largest) == 0) return {};
  const Ring ring(*largest);
  const auto corners = corners_of(ring);
  if (!corners) return {};
  const Polygon border = polygon_around(ring, *corners, rows, columns);
  if (!lies_in(ring, border)) return {};
  LineGrid grid(rows, columns, size, grid_inside(border, rows, columns));
  if (grid.folds()) return {};
  return grid;
}

}  // namespace gradmesh
