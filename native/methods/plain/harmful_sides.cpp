#include "methods/plain/harmful_sides.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "base/clamped_int.h"

namespace gradmesh {
namespace {

/// About as far as the patches beside a side reach, in pixels.
constexpr double near = 32;

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
  if (closest.first < near && std::ranges::find(harmful, closest.second) == harmful.end())
    harmful.push_back(closest.second);
  return harmful;
}

}  // namespace gradmesh
