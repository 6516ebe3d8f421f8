#pragma once

#include <array>
#include <vector>

#include "fit/equations.h"
#include "methods/plain/plain_grid.h"

namespace gradmesh {

/// What moves a Coons patch of a grid: its corners and, for each side that is a curve, the tangents
/// of the grid's side at its two ends, in the grid's direction. Corner k comes first, then tangent
/// `tangent_mover(side, end)`.
inline constexpr int corner_movers = 4, most_movers = corner_movers + 8;

constexpr int tangent_mover(int side, int end) { return corner_movers + 2 * side + end; }

/// How the 16 control vectors of a patch change with a mover, row by row.
using Shares = std::array<double, 16>;

/// Returns how the places of the control vectors move with each mover. Bit k of `curves` says that
/// side k is a curve. Movers that the patch does not have have no shares.
const std::array<Shares, most_movers>& place_shares(int curves);

/// Returns how the colours of the control vectors follow the colour of each corner.
const std::array<Shares, corner_movers>& color_shares();

/// Points of a grid, none at first.
class GridPoints {
 public:
  explicit GridPoints(const PlainGrid& grid)
      : rows_(grid.rows()),
        columns_(grid.columns()),
        has_(std::size_t(rows_ + 1) * std::size_t(columns_ + 1), false) {}

  static GridPoints all(const PlainGrid& grid) {
    GridPoints points(grid);
    points.add({0, grid.rows(), 0, grid.columns()});
    return points;
  }

  /// Rows and columns, the first and the last included; there is none if a last comes before its
  /// first.
  struct Range {
    int first_row, last_row, first_column, last_column;
  };

  /// Adds the points of a range as far as it lies in the grid.
  void add(const Range& range);
  bool contains(int row, int column) const {
    return row >= 0 && row <= rows_ && column >= 0 && column <= columns_ &&
           has_[index(row, column)];
  }
  /// Returns the smallest range that holds all points.
  const Range& bounds() const { return bounds_; }

  /// Calls `visit(row, column)` for each point, row by row.
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (int i = bounds_.first_row; i <= bounds_.last_row; ++i)
      for (int j = bounds_.first_column; j <= bounds_.last_column; ++j)
        if (has_[index(i, j)]) visit(i, j);
  }

 private:
  std::size_t index(int row, int column) const {
    return std::size_t(row) * std::size_t(columns_ + 1) + std::size_t(column);
  }

  int rows_, columns_;
  std::vector<bool> has_;
  Range bounds_{0, -1, 0, -1};
};

/// What a fit may change of a grid: the places of some points, the tangents there of sides that are
/// curves, and, if it may, the colours of those points that are opaque. A line that was smooth at a
/// point stays so: where both of its sides are curves their tangents move together, each by its own
/// factor, and where the other side is straight the tangent is its chord times the factor.
class GridUnknowns {
 public:
  /// Numbers the unknowns of these points. Turns tangents in `grid` that follow a chord into its
  /// direction.
  GridUnknowns(PlainGrid& grid, const GridPoints& points, bool with_colors);

  const Columns& columns() const { return columns_; }
  /// Returns how the unknowns change the patch of a row and a column; empty if none does.
  std::vector<Influence> influences(int row, int column) const;
  /// Returns `grid` after a step in the columns, whose places are those of `to_mesh`. The unknowns
  /// that `stays` names by their numbers do not move.
  PlainGrid moved(const PlainGrid& grid, const Eigen::VectorXd& step, const glm::dmat2& to_mesh,
                  const std::vector<bool>& stays) const;

 private:
  /// A tangent of a side that is a curve, at one of its ends.
  struct Tangent {
    enum Kind { none, stays, free, follows_chord };
    Kind kind = none;
    int unknown = -1;
    double factor = 1;
    /// follows_chord: the points between which the chord runs.
    std::size_t from = 0, to = 0;
  };

  void add_colors(const PlainGrid& grid);
  void number_tangent(const PlainGrid& grid, Along along, int row, int column, int end);
  void follow_chords(PlainGrid& grid) const;
  template <class Visit>
  void for_each_tangent(const Visit& visit) const;

  glm::dvec2 position(const PlainGrid& grid, std::size_t point) const {
    return grid.knot(int(point / width_), int(point % width_)).position;
  }
  std::size_t index(int row, int column) const {
    return std::size_t(row) * width_ + std::size_t(column);
  }

  const GridPoints points_;
  const std::size_t width_;
  int rows_, count_ = 0;
  /// By index(): the unknown that is the point; -1 if the point stays.
  std::vector<int> point_unknowns_;
  /// By Along, index() of the point at which the side begins, and end.
  std::array<std::vector<std::array<Tangent, 2>>, 2> tangents_;
  Columns columns_{0};
};

}  // namespace gradmesh
