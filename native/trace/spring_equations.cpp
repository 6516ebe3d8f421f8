#include "trace/spring_equations.h"

#include <glm/geometric.hpp>

namespace gradmesh {

SpringEquations::SpringEquations(const LineGrid& grid, const TargetPicture& target,
                                 const GridColumns& columns, std::span<const int> points) {
  const glm::dvec2 scale = pixels_per_unit(grid, target);
  for (std::size_t n = 0; n < points.size(); ++n) {
    const KnotColumns& of = columns.of(points[n]);
    for (std::size_t way = 0; way < of.place.size(); ++way) {
      if (of.place[way] < 0) continue;
      sum_.columns.push_back(of.place[way]);
      ways_.emplace_back(n, way_in_pixels(grid.knot(points[n]), way, scale));
    }
  }
  const auto count = Eigen::Index(ways_.size());
  sum_.matrix = Eigen::MatrixXd::Zero(count, count);
  sum_.rhs = Eigen::VectorXd::Zero(count);
}

void SpringEquations::add(double weight, double residual, std::span<const glm::dvec2> by) {
  Eigen::VectorXd slope(Eigen::Index(ways_.size()));
  for (std::size_t i = 0; i < ways_.size(); ++i)
    slope(Eigen::Index(i)) = glm::dot(by[ways_[i].first], ways_[i].second);
  sum_.squares += weight * residual * residual;
  sum_.matrix += weight * slope * slope.transpose();
  sum_.rhs -= weight * residual * slope;
}

}  // namespace gradmesh
