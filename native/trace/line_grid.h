#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "mesh/parts.h"
#include "mesh/rectangle.h"

namespace gradmesh {

/// A grid of patches with straight sides and one colour at each point, over a picture or a shape on
/// it: what is traced of it. A point costs a person one handle, a side none. Its border never
/// changes: points on it slide along it or are held, all others move freely.
class LineGrid {
 public:
  struct Knot {
    /// In the units of the picture's size, y down.
    glm::dvec2 position;
    /// Levels, 0..255: red, green, blue, opacity.
    glm::dvec4 color;
    /// How many ways there are to move it, 0 to 2, and these, of length 1.
    int ways = 2;
    std::array<glm::dvec2, 2> way{glm::dvec2(1, 0), glm::dvec2(0, 1)};

    bool operator==(const Knot&) const = default;
  };

  /// Makes a grid of even patches, both numbers at least 1, in one opaque grey over a picture, from
  /// (0, 0) to its `size`. Of the border's points those at the corners are held.
  LineGrid(int rows, int columns, glm::dvec2 size);
  /// Makes a grid with its points at these places, row by row, on a picture of this size. All
  /// points of the border are held.
  LineGrid(int rows, int columns, glm::dvec2 size, const std::vector<glm::dvec2>& places);

  /// The size of the picture.
  glm::dvec2 size() const { return size_; }
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

  /// Returns the numbers of a patch's corners, clockwise from the upper left one.
  std::array<int, 4> corners(int row, int column) const;
  /// Returns twice the area of the triangle at a corner of a patch, which is positive at all four
  /// corners where the patch does not fold: then it is convex.
  double corner_area(int row, int column, int corner) const;
  /// Returns whether a patch does.
  bool folds() const;

  /// Returns the grid with one line more, along rows or columns, through the middles of the strip
  /// of patches of that number. It looks the same. The line's ends slide along the border.
  LineGrid with_line(Along along, int strip) const;

  /// Returns whether the border stays as it is without the line of points of that number, 1 to
  /// rows() - 1 or columns() - 1: whether neither of its ends is held.
  bool can_lose(Along along, int line) const;
  /// Returns the grid without that line. Patches may fold then.
  LineGrid without_line(Along along, int line) const;

  /// Returns the mesh as build_mesh reads it, row by row.
  MeshParts parts() const;

 private:
  int rows_, columns_;
  glm::dvec2 size_;
  std::vector<Knot> knots_;
};

}  // namespace gradmesh
