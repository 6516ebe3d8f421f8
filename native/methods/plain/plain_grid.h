#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <vector>

#include "form/counts.h"
#include "form/smooth_colors.h"
#include "geom/cubic.h"
#include "mesh/mesh.h"
#include "mesh/parts.h"
#include "mesh/rectangle.h"

namespace gradmesh {

/// A grid of Coons patches with one colour at each point, as one mesh gradient holds it without
/// `tensor`, in terms of what a person handles: points, and the handles of those sides that are
/// curves.
class PlainGrid {
 public:
  struct Knot {
    glm::dvec2 position;
    glm::dvec4 color;

    bool operator==(const Knot&) const = default;
  };
  /// The tangents of a side at its two ends, both in its direction: from left to right or from top
  /// to bottom. Nothing if the side is straight.
  using Bend = std::optional<std::array<glm::dvec2, 2>>;

  /// Makes the plain grid of a mesh that is a grid (find_grid). Twists are lost, and colours
  /// between the corners. Where corners at one point differ in colour the first patch's counts.
  explicit PlainGrid(const Mesh& mesh);

  /// Returns true if the colours between the points follow the neighbours (Mesh::is_smooth).
  bool has_smooth_colors() const { return has_smooth_colors_; }
  int rows() const { return rows_; }
  int columns() const { return columns_; }

  /// The points, by row 0..rows() and column 0..columns().
  Knot& knot(int row, int column) { return knots_[index(row, column)]; }
  const Knot& knot(int row, int column) const { return knots_[index(row, column)]; }

  /// The bend of the side that begins at a point and runs along its row (to the next column) or
  /// along its column.
  Bend& bend(Along along, int row, int column) { return bends_[int(along)][index(row, column)]; }
  const Bend& bend(Along along, int row, int column) const {
    return bends_[int(along)][index(row, column)];
  }
  /// Returns the curve of that side; a straight side has its handles at thirds.
  Cubic<glm::dvec2> side(Along along, int row, int column) const;

  /// Returns true if the line through a point along its row, or along its column, was a curve
  /// without a corner there in the mesh that the grid was made of.
  bool is_smooth(Along along, int row, int column) const {
    return smooth_[int(along)][index(row, column)];
  }
  /// Returns the sine of the angle by which that line turns at the point, 0 to 1; 1 where it turns
  /// by a right angle or more. The point must not be at an end of the line.
  double turn(Along along, int row, int column) const;
  /// Returns the sine of the angle by which the line would turn if both sides were straight.
  double turn_of_chords(Along along, int row, int column) const;

  /// Returns true if nothing of the patch may change (Mesh::is_fixed).
  bool is_fixed(int row, int column) const { return fixed_[index(row, column)]; }
  bool is_fixed_point(int row, int column) const;
  /// Returns true if the side that begins at a point is one of a patch of which nothing may change.
  bool is_fixed_side(Along along, int row, int column) const;
  /// Returns true if the line of points may be taken out: no patch beside it is fixed, nor, where
  /// colours follow the neighbours, one next to these.
  bool may_take_out(Along along, int number) const;
  /// Lets those patches be fixed that are in a grid with as many rows and columns.
  void fix_as(const PlainGrid& other) { fixed_ = other.fixed_; }

  /// Returns the patch of a row and a column, with colours of the model `bilinear`.
  Patch patch(int row, int column) const;
  /// Returns the mesh as build_mesh reads it, row by row.
  MeshParts parts() const;

  /// Takes the line of points `number`, 1 to rows() - 1 (or columns() - 1), out: those along a row
  /// or along a column. Of the two sides at each of its points that become one, a curve is made
  /// that begins and ends as they did, if one of them was a curve.
  void take_out(Along along, int number);

  /// Returns the number of handles that a person sees: points, and two for every side that is a
  /// curve.
  int handles() const;
  MeshCounts counts() const { return {handles(), rows_ * columns_}; }

 private:
  std::size_t index(int row, int column) const {
    return std::size_t(row) * std::size_t(columns_ + 1) + std::size_t(column);
  }

  int rows_, columns_;
  bool has_smooth_colors_;
  std::vector<Knot> knots_;
  /// By Along; the entries behind the last point of a row or a column are not used.
  std::array<std::vector<Bend>, 2> bends_;
  std::array<std::vector<bool>, 2> smooth_;
  /// By the point at which the patch begins.
  std::vector<bool> fixed_;
};

/// The patches of a grid as they are painted. The grid must outlive it, and stay as it is.
class PaintedGrid {
 public:
  explicit PaintedGrid(const PlainGrid& grid);

  /// Returns the patch of a row and a column; one with smooth colours in the model `bicubic`.
  Patch patch(int row, int column) const;
  const PlainGrid& grid() const { return grid_; }

 private:
  const PlainGrid& grid_;
  std::optional<SmoothColors> colors_;
};

}  // namespace gradmesh
