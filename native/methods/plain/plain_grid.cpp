#include "methods/plain/plain_grid.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "form/handles.h"
#include "mesh/rectangle.h"

namespace gradmesh {
namespace {

/// The sine of the largest turn that counts as none, of five degrees.
constexpr double smooth_turn = 0.087;

/// Returns the tangents of a curve, or nothing if it is straight but for rounding.
PlainGrid::Bend bend_of(const Cubic<Value>& curve, double rounding) {
  if (is_straight(curve, rounding)) return std::nullopt;
  return std::array{curve.m0.position, curve.m1.position};
}

/// Returns the sine of the angle between two directions, 1 for a right angle or more; 0 if one of
/// them is none.
double sine_between(const glm::dvec2& before, const glm::dvec2& after) {
  const double lengths = glm::length(before) * glm::length(after);
  if (lengths == 0 || glm::dot(before, after) <= 0) return lengths == 0 ? 0 : 1;
  return std::abs(before.x * after.y - before.y * after.x) / lengths;
}

Cubic<Value> colored(const Cubic<glm::dvec2>& curve, const glm::dvec4& from, const glm::dvec4& to) {
  const glm::dvec4 slope = to - from;
  return {{curve.p0, from}, {curve.m0, slope}, {curve.m1, slope}, {curve.p1, to}};
}

/// Returns the tangents of one curve in the place of two that follow one another: as they begin and
/// end, longer by as much as the whole is longer than each of them.
PlainGrid::Bend joined(const Cubic<glm::dvec2>& a, const Cubic<glm::dvec2>& b) {
  const double length_a = glm::length(a.p1 - a.p0), length_b = glm::length(b.p1 - b.p0);
  const double share = length_a + length_b > 0 ? length_a / (length_a + length_b) : 0.5;
  constexpr double least = 0.05;
  return std::array{a.m0 / std::max(share, least), b.m1 / std::max(1 - share, least)};
}

}  // namespace

PlainGrid::PlainGrid(const Mesh& mesh) : has_smooth_colors_(mesh.is_smooth()) {
  const Rectangle grid = find_grid(mesh).value();
  const double rounding = rounding_of(mesh);
  rows_ = grid.rows;
  columns_ = grid.columns;
  knots_.resize(std::size_t((rows_ + 1) * (columns_ + 1)));
  for (auto& bends : bends_) bends.resize(knots_.size());
  fixed_.assign(knots_.size(), false);
  for (int i = 0; i < rows_; ++i)
    for (int j = 0; j < columns_; ++j)
      fixed_[index(i, j)] = mesh.is_fixed(mesh.face(grid.top(i, j)));
  // The sides of what must stay as it is keep handles that are all but on a line.
  const double exact = last_bits_of(mesh);
  const auto within = [&](Along along, int i, int j) {
    return is_fixed_side(along, i, j) ? exact : rounding;
  };
  for (int i = rows_; i-- > 0;)
    for (int j = columns_; j-- > 0;) {
      const Halfedge top = grid.top(i, j);
      std::array<Cubic<Value>, 4> sides;
      for (int k = 0; k < 4; ++k) sides[k] = mesh.side_of(mesh.sides(top)[k]);
      const int row[] = {i, i, i + 1, i + 1}, column[] = {j, j + 1, j + 1, j};
      for (int k = 0; k < 4; ++k)
        knot(row[k], column[k]) = {sides[k].p0.position, sides[k].p0.color};
      bend(Along::rows, i, j) = bend_of(sides[0], within(Along::rows, i, j));
      bend(Along::columns, i, j + 1) = bend_of(sides[1], within(Along::columns, i, j + 1));
      bend(Along::rows, i + 1, j) = bend_of(sides[2].reversed(), within(Along::rows, i + 1, j));
      bend(Along::columns, i, j) = bend_of(sides[3].reversed(), within(Along::columns, i, j));
    }
  for (const Along along : {Along::rows, Along::columns}) {
    smooth_[int(along)].assign(knots_.size(), false);
    const bool is_row = along == Along::rows;
    for (int i = !is_row; i <= rows_ - !is_row; ++i)
      for (int j = is_row; j <= columns_ - is_row; ++j) {
        const bool is_curve = bend(along, i, j) || bend(along, i - !is_row, j - is_row);
        smooth_[int(along)][index(i, j)] = is_curve && turn(along, i, j) < smooth_turn;
      }
  }
}

double PlainGrid::turn(Along along, int row, int column) const {
  const bool is_row = along == Along::rows;
  return sine_between(side(along, row - !is_row, column - is_row).m1, side(along, row, column).m0);
}

double PlainGrid::turn_of_chords(Along along, int row, int column) const {
  const int down = along == Along::columns, right = along == Along::rows;
  const glm::dvec2 at = knot(row, column).position;
  return sine_between(at - knot(row - down, column - right).position,
                      knot(row + down, column + right).position - at);
}

Cubic<glm::dvec2> PlainGrid::side(Along along, int row, int column) const {
  const glm::dvec2 from = knot(row, column).position;
  const glm::dvec2 to =
      (along == Along::rows ? knot(row, column + 1) : knot(row + 1, column)).position;
  const Bend& bent = bend(along, row, column);
  return bent ? Cubic<glm::dvec2>{from, (*bent)[0], (*bent)[1], to}
              : Cubic<glm::dvec2>{from, to - from, to - from, to};
}

Patch PlainGrid::patch(int row, int column) const {
  const auto color = [&](int i, int j) -> const glm::dvec4& { return knot(i, j).color; };
  const std::array<Cubic<Value>, 4> sides = {
      colored(side(Along::rows, row, column), color(row, column), color(row, column + 1)),
      colored(side(Along::columns, row, column + 1), color(row, column + 1),
              color(row + 1, column + 1)),
      colored(side(Along::rows, row + 1, column), color(row + 1, column),
              color(row + 1, column + 1))
          .reversed(),
      colored(side(Along::columns, row, column), color(row, column), color(row + 1, column))
          .reversed()};
  Patch patch = patch_from_sides(sides, {});
  make_coons(patch);
  make_color_bilinear(patch);
  return patch;
}

MeshParts PlainGrid::parts() const {
  MeshParts parts{{}, grid_curves(rows_, columns_)};
  parts.smooth = has_smooth_colors_;
  for (int i = 0; i < rows_; ++i)
    for (int j = 0; j < columns_; ++j) {
      if (is_fixed(i, j)) parts.fixed.push_back(int(parts.patches.size()));
      parts.patches.push_back(patch(i, j));
    }
  return parts;
}

bool PlainGrid::is_fixed_point(int row, int column) const {
  for (const int i : {row - 1, row})
    for (const int j : {column - 1, column})
      if (i >= 0 && j >= 0 && i < rows_ && j < columns_ && is_fixed(i, j)) return true;
  return false;
}

bool PlainGrid::is_fixed_side(Along along, int row, int column) const {
  const int above = along == Along::rows, left = along == Along::columns;
  const auto is_fixed_at = [&](int i, int j) {
    return i >= 0 && j >= 0 && i < rows_ && j < columns_ && is_fixed(i, j);
  };
  return is_fixed_at(row, column) || is_fixed_at(row - above, column - left);
}

bool PlainGrid::may_take_out(Along along, int number) const {
  const int ring = has_smooth_colors_;
  const int lines = along == Along::rows ? rows_ : columns_;
  const int length = along == Along::rows ? columns_ : rows_;
  for (int i = std::max(number - 1 - ring, 0); i <= std::min(number + ring, lines - 1); ++i)
    for (int k = 0; k < length; ++k)
      if (along == Along::rows ? is_fixed(i, k) : is_fixed(k, i)) return false;
  return true;
}

void PlainGrid::take_out(Along along, int number) {
  const Along across = along == Along::rows ? Along::columns : Along::rows;
  const bool is_row = along == Along::rows;
  const int length = is_row ? columns_ : rows_;
  const auto at = [&](int line, int place) {
    return is_row ? index(line, place) : index(place, line);
  };
  const auto side_across = [&](int line, int place) {
    return is_row ? side(across, line, place) : side(across, place, line);
  };
  for (int k = 0; k <= length; ++k) {
    Bend& before = bends_[int(across)][at(number - 1, k)];
    if (before || bends_[int(across)][at(number, k)])
      before = joined(side_across(number - 1, k), side_across(number, k));
  }
  const auto erase_line = [&](auto& values) {
    std::remove_reference_t<decltype(values)> left;
    for (int i = 0; i <= rows_; ++i)
      for (int j = 0; j <= columns_; ++j)
        if ((is_row ? i : j) != number) left.push_back(values[index(i, j)]);
    values = std::move(left);
  };
  erase_line(knots_);
  for (auto& bends : bends_) erase_line(bends);
  for (auto& smooth : smooth_) erase_line(smooth);
  erase_line(fixed_);
  --(is_row ? rows_ : columns_);
}

int PlainGrid::handles() const {
  int count = int(knots_.size());
  for (int i = 0; i <= rows_; ++i)
    for (int j = 0; j <= columns_; ++j) {
      if (j < columns_ && bend(Along::rows, i, j)) count += 2;
      if (i < rows_ && bend(Along::columns, i, j)) count += 2;
    }
  return count;
}

PaintedGrid::PaintedGrid(const PlainGrid& grid) : grid_(grid) {
  if (!grid.has_smooth_colors()) return;
  std::vector<SmoothColors::Corner> corners;
  for (int i = 0; i <= grid.rows(); ++i)
    for (int j = 0; j <= grid.columns(); ++j) {
      const auto& [position, color] = grid.knot(i, j);
      corners.push_back({position, glm::dvec3(color)});
    }
  colors_.emplace(grid.rows(), grid.columns(), corners);
}

Patch PaintedGrid::patch(int row, int column) const {
  Patch patch = grid_.patch(row, column);
  if (colors_) colors_->apply(patch, row, column);
  return patch;
}

}  // namespace gradmesh
