#include "trace/slivers.h"

#include <array>
#include <glm/geometric.hpp>

#include "geom/cross.h"
#include "trace/spring_equations.h"

namespace gradmesh {
namespace {

/// More than the pixel and the 5 degrees that are wanted, as it is a spring that holds patches
/// there.
constexpr double least_width = 1.2, least_sine = 0.12;

/// What a patch lacks of a width or of the sine of a corner, as a share of the least of it, and how
/// that changes with the patch's corners.
struct Lack {
  double share = 0;
  std::array<glm::dvec2, 4> by{};
};

glm::dvec2 across(glm::dvec2 way) { return {way.y, -way.x}; }

/// Returns what the corner lacks. The sine falls below 0 where the patch folds.
Lack lack_of_corner(const Quad& quad, std::size_t corner) {
  const std::size_t next = (corner + 1) & 3, last = (corner + 3) & 3;
  const glm::dvec2 a = quad[next] - quad[corner], b = quad[last] - quad[corner];
  const double length_a = glm::length(a), length_b = glm::length(b);
  if (!(length_a > 0) || !(length_b > 0)) return {};
  const double sine = cross(a, b) / (length_a * length_b);
  if (sine >= least_sine) return {};
  Lack lack{(least_sine - sine) / least_sine};
  lack.by[next] =
      (sine / (length_a * length_a) * a - across(b) / (length_a * length_b)) / least_sine;
  lack.by[last] =
      (sine / (length_b * length_b) * b + across(a) / (length_a * length_b)) / least_sine;
  lack.by[corner] = -lack.by[next] - lack.by[last];
  return lack;
}

/// Returns what the patch lacks across the side that begins at a corner. Its width there is how far
/// the farther one of the other two corners is from the side.
Lack lack_of_side(const Quad& quad, std::size_t corner) {
  const std::size_t next = (corner + 1) & 3, opposite = (corner + 2) & 3, last = (corner + 3) & 3;
  const glm::dvec2 side = quad[next] - quad[corner];
  const double length = glm::length(side);
  if (!(length > 0)) return {};
  const auto away = [&](std::size_t k) { return cross(side, quad[k] - quad[corner]) / length; };
  const std::size_t farther = away(opposite) > away(last) ? opposite : last;
  const double width = away(farther);
  if (width >= least_width) return {};
  const glm::dvec2 way = quad[farther] - quad[corner];
  Lack lack{(least_width - width) / least_width};
  lack.by[next] = (width / (length * length) * side - across(way) / length) / least_width;
  lack.by[farther] = across(side) / (length * least_width);
  lack.by[corner] = -lack.by[next] - lack.by[farther];
  return lack;
}

/// Calls `f(lack)` for whatever a patch lacks.
template <class F>
void for_each_lack(Quad quad, glm::dvec2 scale, const F& f) {
  for (glm::dvec2& place : quad) place *= scale;
  for (std::size_t corner = 0; corner < 4; ++corner)
    for (const Lack& lack : {lack_of_corner(quad, corner), lack_of_side(quad, corner)})
      if (lack.share > 0) f(lack);
}

}  // namespace

std::vector<NormalEquations> sliver_equations(const LineGrid& grid, const TargetPicture& target,
                                              const GridColumns& columns, double weight) {
  const glm::dvec2 scale = pixels_per_unit(grid, target);
  std::vector<NormalEquations> all;
  for (int row = 0; row < grid.rows(); ++row)
    for (int column = 0; column < grid.columns(); ++column) {
      SpringEquations patch(grid, target, columns, grid.corners(row, column));
      for_each_lack(grid.quad(row, column), scale,
                    [&](const Lack& lack) { patch.add(weight, lack.share, lack.by); });
      all.push_back(patch.sum());
    }
  return all;
}

double sliver_squares(const LineGrid& grid, const TargetPicture& target, double weight) {
  const glm::dvec2 scale = pixels_per_unit(grid, target);
  double shares = 0;
  for (int row = 0; row < grid.rows(); ++row)
    for (int column = 0; column < grid.columns(); ++column)
      for_each_lack(grid.quad(row, column), scale,
                    [&](const Lack& lack) { shares += lack.share * lack.share; });
  return weight * shares;
}

}  // namespace gradmesh
