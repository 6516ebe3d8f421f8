#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <unordered_map>
#include <vector>

namespace gradmesh {

/// Gives points numbers, the same to those that are as close as what rounding moves them. What is
/// close to several is one with the first that was there.
class WeldedPoints {
 public:
  /// `tolerance`, above 0, is the largest difference of a coordinate.
  explicit WeldedPoints(double tolerance) : tolerance_(tolerance) {}

  /// Returns the number of a point, which must be finite.
  int number(glm::dvec2 point);
  /// Returns the point that was the first of a number.
  glm::dvec2 point(int number) const { return points_[std::size_t(number)]; }

 private:
  struct Cell {
    std::int64_t x, y;
    bool operator==(const Cell&) const = default;
  };
  struct CellHash {
    std::size_t operator()(const Cell& cell) const;
  };

  Cell cell_of(glm::dvec2 point) const;

  double tolerance_;
  std::vector<glm::dvec2> points_;
  std::unordered_map<Cell, std::vector<int>, CellHash> cells_;
};

}  // namespace gradmesh
