#include "methods/plain/flaws.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "base/clamped_int.h"
#include "base/parallel.h"
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

/// Returns the narrowest_share() of each patch.
std::vector<double> narrowest_shares(const PlainGrid& grid) {
  const auto columns = std::size_t(grid.columns());
  std::vector<double> shares(std::size_t(grid.rows()) * columns);
  parallel_for(std::size_t(grid.rows()), [&](std::size_t i) {
    for (std::size_t k = 0; k < columns; ++k)
      shares[i * columns + k] = narrowest_share(grid.patch(int(i), int(k)));
  });
  return shares;
}

/// Returns the gap of border_gap at one side; `farthest` where no outline is near.
double gap_of(const PlainGrid& grid, Along along, int row, int column, const Reference& picture) {
  constexpr double farthest = 10, spacing = 3;
  const Affine& to_pixels = picture.frame().to_pixels;
  const Cubic<glm::dvec2> side = grid.side(along, row, column);
  const double length = glm::length(to_pixels.vector(side.p1 - side.p0));
  const int steps = clamped_int(length / spacing, 4, 100);
  double gap = 0;
  for (int i = 0; i <= steps; ++i) {
    const glm::dvec2 place = to_pixels.point(side.at(double(i) / steps));
    if (picture.is_hidden(place)) continue;
    const auto outline = picture.outline_near(place);
    gap = std::max(gap, outline ? glm::length(place - outline->place) : farthest);
  }
  return gap;
}

/// Returns how much is seen of the corner at a point of a line between two straight sides, of which
/// `made_straight` counts as one; 0 where there is none, or where the line was not smooth.
double corner_at(const PlainGrid& grid, Along along, int row, int column,
                 const Side* made_straight = nullptr) {
  const int down = along == Along::columns, right = along == Along::rows;
  const bool is_inside =
      right ? column > 0 && column < grid.columns() : row > 0 && row < grid.rows();
  if (!is_inside || !grid.is_smooth(along, row, column)) return 0;
  const auto is_curve = [&](const Side& side) {
    return grid.bend(side.along, side.row, side.column) &&
           !(made_straight && *made_straight == side);
  };
  if (is_curve({along, row, column}) || is_curve({along, row - down, column - right})) return 0;
  double contrast = 0;
  for (const int beside : {-1, 1}) {
    const int i = row + beside * right, j = column + beside * down;
    if (i < 0 || j < 0 || i > grid.rows() || j > grid.columns()) continue;
    const glm::dvec4 d = glm::abs(grid.knot(i, j).color - grid.knot(row, column).color);
    contrast = std::max({contrast, d.r, d.g, d.b, d.a});
  }
  return contrast * grid.turn_of_chords(along, row, column);
}

/// Fits after a step may turn corners a little further than where they are first seen.
constexpr double most_corner = 1.5 * seen_corner;

/// About as far as the patches beside a side reach, in pixels.
constexpr double within_reach = 32;

/// Returns places along a side, in pixels.
std::vector<glm::dvec2> places_along(const PlainGrid& grid, const Side& side, const Frame& frame) {
  constexpr int pieces = 24;
  const Cubic<glm::dvec2> curve = grid.side(side.along, side.row, side.column);
  std::vector<glm::dvec2> places;
  for (int i = 0; i <= pieces; ++i)
    places.push_back(frame.to_pixels.point(curve.at(double(i) / pieces)));
  return places;
}

glm::dvec2 largest_of(const Plane& errors) {
  const auto largest = std::ranges::max_element(errors.samples) - errors.samples.begin();
  return {double(largest % errors.width), double(largest / errors.width)};
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
  for (const double share : narrowest_shares(start))
    if (share > 0) least_share_ = std::min(least_share_, kept * share);
  at_first_ = counted(start);
}

Crush::Count Crush::counted(const PlainGrid& grid) const {
  Count count;
  for (const double share : narrowest_shares(grid)) {
    count.pinched += share < least_share_;
    count.folded += share < 0;
  }
  return count;
}

double border_gap(const PlainGrid& grid, const Reference& picture) {
  double gap = 0;
  for (const int row : {0, grid.rows()})
    for (int j = 0; j < grid.columns(); ++j)
      gap = std::max(gap, gap_of(grid, Along::rows, row, j, picture));
  for (const int column : {0, grid.columns()})
    for (int i = 0; i < grid.rows(); ++i)
      gap = std::max(gap, gap_of(grid, Along::columns, i, column, picture));
  return gap;
}

double largest_corner(const PlainGrid& grid) {
  double most = 0;
  for (const Along along : {Along::rows, Along::columns})
    for (int i = 0; i <= grid.rows(); ++i)
      for (int j = 0; j <= grid.columns(); ++j) most = std::max(most, corner_at(grid, along, i, j));
  return most;
}

bool makes_corner(const PlainGrid& grid, const Side& side) {
  const int down = side.along == Along::columns, right = side.along == Along::rows;
  return corner_at(grid, side.along, side.row, side.column, &side) > seen_corner ||
         corner_at(grid, side.along, side.row + down, side.column + right, &side) > seen_corner;
}

Flaws::Flaws(const PlainGrid& start, const Reference& picture)
    : picture_(picture),
      largest_corner_(std::max(most_corner, largest_corner(start))),
      largest_gap_(std::max(seen_gap, border_gap(start, picture))),
      crush_(start) {}

bool Flaws::are_worse(const PlainGrid& grid) const {
  return largest_corner(grid) > largest_corner_ || border_gap(grid, picture_) > largest_gap_ ||
         crush_.is_worse(grid);
}

std::vector<Side> harmful_sides(const std::vector<Side>& sides, const PlainGrid& grid,
                                const Plane& errors, double bound, const Frame& frame) {
  const glm::dvec2 worst = largest_of(errors);
  std::vector<Side> harmful;
  std::pair<double, Side> closest{std::numeric_limits<double>::infinity(), {}};
  for (const Side& side : sides) {
    double error = 0, distance = std::numeric_limits<double>::infinity();
    for (const glm::dvec2 place : places_along(grid, side, frame)) {
      distance = std::min(distance, glm::length(place - worst));
      const int x = clamped_pixel(std::floor(place.x)), y = clamped_pixel(std::floor(place.y));
      if (x >= 0 && y >= 0 && x < errors.width && y < errors.height)
        error = std::max(error, double(*errors.at(x, y)));
    }
    if (error > bound) harmful.push_back(side);
    if (distance < closest.first) closest = {distance, side};
  }
  if (closest.first < within_reach && std::ranges::find(harmful, closest.second) == harmful.end())
    harmful.push_back(closest.second);
  return harmful;
}

}  // namespace gradmesh
