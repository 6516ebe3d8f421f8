#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "mesh/parts.h"
#include "mesh/rectangle.h"

namespace gradmesh {

/// A grid of patches with straight sides and one colour at each point, over a rectangle whose sides
/// lie along the axes: what is traced of a picture. A point costs a person one handle, a side none.
class LineGrid {
 public:
  struct Knot {
    /// In the units of the rectangle, y down.
    glm::dvec2 position;
    /// Levels, 0..255: red, green, blue, opacity.
    glm::dvec4 color;

    bool operator==(const Knot&) const = default;
  };

  /// Makes a grid of even patches, both numbers at least 1, in one opaque grey from (0, 0) to
  /// `size`.
  LineGrid(int rows, int columns, glm::dvec2 size);

  glm::dvec2 size() const { return knots_.back().position; }
  int rows() const { return rows_; }
  int columns() const { return columns_; }
  int points() const { return (rows_ + 1) * (columns_ + 1); }
  bool operator==(const LineGrid&) const = default;

  /// The points, by row 0..rows() and column 0..columns(), and their numbers, row by row.
  int number(int row, int column) const { return row * (columns_ + 1) + column; }
  Knot& knot(int number) { return knots_[std::size_t(number)]; }
  const Knot& knot(int number) const { return knots_[std::size_t(number)]; }
  Knot& knot(int row, int column) { return knot(number(row, column)); }
  const Knot& knot(int row, int column) const { return knot(number(row, column)); }

  /// Return whether a point may move along x, or along y: those of the border stay on it.
  bool moves_in_x(int number) const;
  bool moves_in_y(int number) const;

  /// Returns the numbers of a patch's corners, clockwise from the upper left one.
  std::array<int, 4> corners(int row, int column) const;
  /// Returns twice the area of the triangle at a corner of a patch, which is positive at all four
  /// corners where the patch does not fold: then it is convex.
  double corner_area(int row, int column, int corner) const;

  /// Returns the grid with one line more, along rows or columns, through the middles of the strip
  /// of patches of that number. It looks the same.
  LineGrid with_line(Along along, int strip) const;

  /// Returns the grid without the line of points of that number, 1 to rows() - 1 or columns() - 1.
  /// Patches may fold then.
  LineGrid without_line(Along along, int line) const;

  /// Returns the mesh as build_mesh reads it, row by row.
  MeshParts parts() const;

 private:
  int rows_, columns_;
  std::vector<Knot> knots_;
};

}  // namespace gradmesh
