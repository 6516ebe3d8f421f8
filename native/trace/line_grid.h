#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "mesh/parts.h"
#include "mesh/rectangle.h"
#include "trace/guide.h"
#include "trace/pixels.h"

namespace gradmesh {

/// A grid of patches with straight sides and one colour at each point, over a picture or a shape on
/// it: what is traced of it. A point costs a person one handle, a side none. Its border never
/// changes: points on it slide along it or are held. Points on guides slide along these or are held
/// too; all others move freely.
class LineGrid {
 public:
  /// Which guide a line follows at a point, if any, and the way along the guide to the point.
  struct OnGuide {
    int guide = -1;
    double way = 0;

    bool operator==(const OnGuide&) const = default;
  };

  struct Knot {
    /// In the units of the picture's size, y down.
    glm::dvec2 position;
    /// Levels, 0..255: red, green, blue, opacity.
    glm::dvec4 color;
    /// How many ways there are to move it, 0 to 2, and these, of length 1.
    int ways = 2;
    std::array<glm::dvec2, 2> way{glm::dvec2(1, 0), glm::dvec2(0, 1)};
    /// What the point's line along rows follows, and its line along columns. A point of which both
    /// follow a guide is held where these cross.
    std::array<OnGuide, 2> on{};

    OnGuide& on_guide(Along along) { return on[along == Along::rows ? 0 : 1]; }
    const OnGuide& on_guide(Along along) const { return on[along == Along::rows ? 0 : 1]; }
    bool follows(Along along) const { return on_guide(along).guide >= 0; }
    bool is_held() const { return ways == 0; }

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
  int patches() const { return rows_ * columns_; }
  bool operator==(const LineGrid&) const = default;

  /// The points, by row 0..rows() and column 0..columns(), and their numbers, row by row.
  int number(int row, int column) const { return row * (columns_ + 1) + column; }
  Knot& knot(int number) { return knots_[std::size_t(number)]; }
  const Knot& knot(int number) const { return knots_[std::size_t(number)]; }
  Knot& knot(int row, int column) { return knot(number(row, column)); }
  const Knot& knot(int row, int column) const { return knot(number(row, column)); }

  /// Returns the numbers of a patch's corners, clockwise from the upper left one.
  std::array<int, 4> corners(int row, int column) const;
  /// Returns their places.
  Quad quad(int row, int column) const;
  /// Returns twice the area of the triangle at a corner of a patch, which is positive at all four
  /// corners where the patch does not fold: then it is convex.
  double corner_area(int row, int column, int corner) const;
  /// Returns the grid with colours as documents have them.
  LineGrid in_whole_levels() const;

  /// Returns whether a patch does.
  bool folds() const;

  /// Returns how many points a line along rows or columns has, and how many strips of patches there
  /// are along these.
  int points_along(Along along) const { return 1 + (along == Along::rows ? columns_ : rows_); }
  int strips(Along along) const { return along == Along::rows ? rows_ : columns_; }
  /// Returns the number of a point of a line along rows or columns.
  int number(Along along, int line, int point) const {
    return along == Along::rows ? number(line, point) : number(point, line);
  }

  /// The guides that lines follow.
  const std::vector<Guide>& guides() const { return guides_; }
  /// Adds a guide, which no line follows yet. Returns its number.
  int add_guide(const Guide& guide);
  /// Puts a point, whose line along rows or columns is to follow a guide, on the guide at a way. It
  /// slides along the guide from then on.
  void put_on_guide(int number, Along along, const OnGuide& on);

  /// Returns the grid with one line more, along rows or columns, through the middles of the strip
  /// of patches of that number. It looks the same but for guides across the strip, on which the
  /// line's points are. The line's ends slide along the border.
  LineGrid with_line(Along along, int strip) const;

  /// Returns whether the border and what guides reach stay as they are without the line of points
  /// of that number, 1 to rows() - 1 or columns() - 1: whether it follows no guide, and none of its
  /// points is held.
  bool can_lose(Along along, int line) const;
  /// Returns the grid without that line. Patches may fold then.
  LineGrid without_line(Along along, int line) const;

  /// Returns the mesh as build_mesh reads it, row by row.
  MeshParts parts() const;

 private:
  int rows_, columns_;
  glm::dvec2 size_;
  std::vector<Knot> knots_;
  std::vector<Guide> guides_;
};

}  // namespace gradmesh
