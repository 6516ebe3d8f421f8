#include "trace/evenness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "trace/spring_equations.h"

namespace gradmesh {
namespace {

/// Three points in a row of a line, in pixels.
struct Triple {
  std::array<int, 3> numbers;
  std::array<glm::dvec2, 3> at;
};

template <class F>
void for_each_triple(const LineGrid& grid, const TargetPicture& target, const F& f) {
  const glm::dvec2 scale = pixels_per_unit(grid, target);
  const auto visit = [&](int a, int b, int c) {
    f(Triple{{a, b, c},
             {scale * grid.knot(a).position, scale * grid.knot(b).position,
              scale * grid.knot(c).position}});
  };
  for (int i = 0; i <= grid.rows(); ++i)
    for (int j = 0; j <= grid.columns(); ++j) {
      const int here = grid.number(i, j);
      if (j > 0 && j < grid.columns()) visit(here - 1, here, here + 1);
      if (i > 0 && i < grid.rows()) visit(grid.number(i - 1, j), here, grid.number(i + 1, j));
    }
}

/// A number that is 0 where the triple is even, and how it changes with the three points.
struct Residual {
  double value;
  std::array<glm::dvec2, 3> by;
};

/// Returns how far the middle point is from half-way, in x or in y.
Residual off_middle(const Triple& t, int axis) {
  Residual residual{t.at[0][axis] - 2 * t.at[1][axis] + t.at[2][axis], {}};
  constexpr double share[] = {1, -2, 1};
  for (std::size_t k = 0; k < 3; ++k) residual.by[k][axis] = share[k];
  return residual;
}

/// Returns how far the middle point is from the straight line between the others.
Residual off_line(const Triple& t) {
  const glm::dvec2 way = t.at[2] - t.at[0];
  const double length = glm::length(way);
  if (length < 1e-6) return {0, {}};
  const glm::dvec2 normal(-way.y / length, way.x / length);
  const double along = std::clamp(glm::dot(way, t.at[1] - t.at[0]) / (length * length), 0.0, 1.0);
  return {glm::dot(normal, t.at[1] - t.at[0] - along * way),
          {-(1 - along) * normal, normal, -along * normal}};
}

/// What makes a triple uneven: a residual, and how much its square counts.
std::array<std::pair<Residual, double>, 3> residuals_of(const Triple& t, const Evenness& by) {
  return {{{off_middle(t, 0), by.spacing},
           {off_middle(t, 1), by.spacing},
           {off_line(t), by.straightness}}};
}

}  // namespace

Evenness Evenness::for_patches(double squares) const {
  // Found by traces of ten pictures; less than in proportion, as texture leaves squares that no
  // place of a line takes away.
  constexpr double usual_squares = 6e4, power = 0.7, least = 1;
  return times(std::pow(std::max(least, squares) / usual_squares, power));
}

std::vector<NormalEquations> evenness_equations(const LineGrid& grid, const TargetPicture& target,
                                                const GridColumns& columns, const Evenness& by) {
  std::vector<NormalEquations> all;
  for_each_triple(grid, target, [&](const Triple& t) {
    SpringEquations triple(grid, target, columns, t.numbers);
    for (const auto& [residual, weight] : residuals_of(t, by))
      triple.add(weight, residual.value, residual.by);
    all.push_back(triple.sum());
  });
  return all;
}

double unevenness(const LineGrid& grid, const TargetPicture& target, const Evenness& by) {
  double squares = 0;
  for_each_triple(grid, target, [&](const Triple& t) {
    for (const auto& [residual, weight] : residuals_of(t, by))
      squares += weight * residual.value * residual.value;
  });
  return squares;
}

}  // namespace gradmesh
