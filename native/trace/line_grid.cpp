#include "trace/line_grid.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "geom/cross.h"

namespace gradmesh {
namespace {

Value value_of(const LineGrid::Knot& knot) { return {knot.position, knot.color / 255.0}; }

LineGrid::Knot middle(const LineGrid::Knot& a, const LineGrid::Knot& b) {
  return {0.5 * (a.position + b.position), 0.5 * (a.color + b.color)};
}

void let_slide(LineGrid::Knot& knot, glm::dvec2 along) {
  const double length = glm::length(along);
  knot.ways = length > 0 ? 1 : 0;
  if (length > 0) knot.way[0] = along / length;
}

/// Returns the patch with straight sides whose corners have these values.
Patch straight_patch(const std::array<LineGrid::Knot, 4>& corners) {
  const Value a = value_of(corners[0]), b = value_of(corners[1]), c = value_of(corners[2]),
              d = value_of(corners[3]), top = b - a, bottom = c - d, twist = bottom - top;
  Patch patch;
  patch.c = {{{a, top, top, b},
              {d - a, twist, twist, c - b},
              {d - a, twist, twist, c - b},
              {d, bottom, bottom, c}}};
  return patch;
}

}  // namespace

LineGrid::LineGrid(int rows, int columns, glm::dvec2 size)
    : rows_(rows), columns_(columns), size_(size) {
  constexpr double grey = 128, opaque = 255;
  for (int i = 0; i <= rows; ++i)
    for (int j = 0; j <= columns; ++j) {
      Knot& knot =
          knots_.emplace_back(Knot{size * glm::dvec2(double(j) / columns, double(i) / rows),
                                   glm::dvec4(grey, grey, grey, opaque)});
      const bool is_at_side = j == 0 || j == columns, is_at_end = i == 0 || i == rows;
      if (is_at_side || is_at_end) let_slide(knot, {is_at_side ? 0 : 1, is_at_end ? 0 : 1});
    }
}

LineGrid::LineGrid(int rows, int columns, glm::dvec2 size, const std::vector<glm::dvec2>& places)
    : LineGrid(rows, columns, size) {
  for (int n = 0; n < points(); ++n) {
    knot(n).position = places[std::size_t(n)];
    if (knot(n).ways < 2) knot(n).ways = 0;
  }
}

std::array<int, 4> LineGrid::corners(int row, int column) const {
  const int first = number(row, column), below = number(row + 1, column);
  return {first, first + 1, below + 1, below};
}

Quad LineGrid::quad(int row, int column) const {
  const std::array<int, 4> at = corners(row, column);
  return {knot(at[0]).position, knot(at[1]).position, knot(at[2]).position, knot(at[3]).position};
}

double LineGrid::corner_area(int row, int column, int corner) const {
  const Quad q = quad(row, column);
  const glm::dvec2 here = q[std::size_t(corner)];
  return cross(q[std::size_t(corner + 1) & 3] - here, q[std::size_t(corner + 3) & 3] - here);
}

bool LineGrid::folds() const {
  for (int i = 0; i < rows_; ++i)
    for (int j = 0; j < columns_; ++j)
      for (int corner = 0; corner < 4; ++corner)
        if (!(corner_area(i, j, corner) > 0)) return true;
  return false;
}

LineGrid LineGrid::in_whole_levels() const {
  LineGrid whole = *this;
  for (Knot& knot : whole.knots_) knot.color = glm::round(knot.color);
  return whole;
}

int LineGrid::add_guide(const Guide& guide) {
  guides_.push_back(guide);
  return int(guides_.size()) - 1;
}

void LineGrid::put_on_guide(int number, Along along, const OnGuide& on) {
  const Guide& guide = guides_[std::size_t(on.guide)];
  const double way = std::clamp(on.way, 0.0, guide.length());
  Knot& knot = this->knot(number);
  knot.on_guide(along) = {on.guide, way};
  knot.position = guide.at(way);
  knot.ways = 1;
  knot.way[0] = guide.direction(way);
}

LineGrid LineGrid::with_line(Along along, int strip) const {
  LineGrid finer = *this;
  finer.knots_.clear();
  const bool is_row = along == Along::rows;
  (is_row ? finer.rows_ : finer.columns_) += 1;
  for (int i = 0; i <= finer.rows_; ++i)
    for (int j = 0; j <= finer.columns_; ++j) {
      // The line is the one after the strip's first.
      const int line = is_row ? i : j;
      const int after = line > strip + 1 ? 1 : 0;
      const int row = i - (is_row ? after : 0), column = j - (is_row ? 0 : after);
      if (line != strip + 1) {
        finer.knots_.push_back(knot(row, column));
        continue;
      }
      const Knot &before = knot(row - is_row, column - !is_row), &next = knot(row, column);
      Knot& end = finer.knots_.emplace_back(middle(before, next));
      const bool is_on_border =
          is_row ? column == 0 || column == columns_ : row == 0 || row == rows_;
      if (is_on_border) let_slide(end, next.position - before.position);
      const Along across = is_row ? Along::columns : Along::rows;
      const OnGuide &from = before.on_guide(across), &to = next.on_guide(across);
      if (from.guide >= 0 && from.guide == to.guide)
        finer.put_on_guide(int(finer.knots_.size()) - 1, across,
                           {from.guide, (from.way + to.way) / 2});
    }
  return finer;
}

bool LineGrid::can_lose(Along along, int line) const {
  for (int k = 0; k < points_along(along); ++k) {
    const Knot& knot = this->knot(number(along, line, k));
    if (knot.is_held() || knot.follows(along)) return false;
  }
  return true;
}

LineGrid LineGrid::without_line(Along along, int line) const {
  LineGrid coarser = *this;
  coarser.knots_.clear();
  const bool is_row = along == Along::rows;
  (is_row ? coarser.rows_ : coarser.columns_) -= 1;
  for (int i = 0; i <= rows_; ++i)
    for (int j = 0; j <= columns_; ++j)
      if ((is_row ? i : j) != line) coarser.knots_.push_back(knot(i, j));
  return coarser;
}

MeshParts LineGrid::parts() const {
  MeshParts parts{{}, grid_curves(rows_, columns_)};
  for (int i = 0; i < rows_; ++i)
    for (int j = 0; j < columns_; ++j) {
      const std::array<int, 4> at = corners(i, j);
      parts.patches.push_back(straight_patch({knot(at[0]), knot(at[1]), knot(at[2]), knot(at[3])}));
    }
  return parts;
}

}  // namespace gradmesh
