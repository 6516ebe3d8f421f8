#include "methods/plain/grid_unknowns.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "geom/cubic.h"
#include "mesh/mesh.h"

namespace gradmesh {
namespace {

/// Returns a side of a patch, which runs clockwise: the bottom and the left against the grid, whose
/// tangents these are.
Cubic<Value> clockwise(int side, const glm::dvec2& from, const std::array<glm::dvec2, 2>& tangents,
                       const glm::dvec2& to) {
  Cubic<Value> curve;
  const bool runs_back = side >= 2;
  curve.p0.position = from;
  curve.m0.position = runs_back ? -tangents[1] : tangents[0];
  curve.m1.position = runs_back ? -tangents[0] : tangents[1];
  curve.p1.position = to;
  return curve;
}

/// The patch is linear in its movers, so each is tried with the length 1 along x.
Shares place_shares_of(int mover, int curves) {
  std::array<Cubic<Value>, 4> sides;
  const auto corner = [&](int k) { return glm::dvec2(k % 4 == mover ? 1 : 0, 0); };
  for (int k = 0; k < 4; ++k) {
    // As the grid has them: from left to right or from top to bottom.
    const glm::dvec2 chord = (k >= 2 ? -1.0 : 1.0) * (corner(k + 1) - corner(k));
    std::array<glm::dvec2, 2> tangents = {chord, chord};
    if ((curves >> k & 1) != 0)
      for (int end = 0; end < 2; ++end)
        tangents[std::size_t(end)] = glm::dvec2(mover == tangent_mover(k, end) ? 1 : 0, 0);
    sides[std::size_t(k)] = clockwise(k, corner(k), tangents, corner(k + 1));
  }
  Patch patch = patch_from_sides(sides, {});
  make_coons(patch);
  Shares shares;
  for (std::size_t c = 0; c < 16; ++c) shares[c] = patch.c[c / 4][c % 4].position.x;
  return shares;
}

Shares color_shares_of(int mover) {
  std::array<Cubic<Value>, 4> sides;
  for (int k = 0; k < 4; ++k) {
    Cubic<Value>& side = sides[std::size_t(k)];
    side.p0.color = glm::dvec4(k == mover);
    side.p1.color = glm::dvec4((k + 1) % 4 == mover);
    side.m0.color = side.m1.color = side.p1.color - side.p0.color;
  }
  Patch patch = patch_from_sides(sides, {});
  make_coons(patch);
  make_color_bilinear(patch);
  Shares shares;
  for (std::size_t c = 0; c < 16; ++c) shares[c] = patch.c[c / 4][c % 4].color.x;
  return shares;
}

/// A side of a patch as the grid names it.
struct SideName {
  Along along;
  int row, column;
};

SideName side_name(int row, int column, int side) {
  switch (side) {
    case 0:
      return {Along::rows, row, column};
    case 1:
      return {Along::columns, row, column + 1};
    case 2:
      return {Along::rows, row + 1, column};
    default:
      return {Along::columns, row, column};
  }
}

}  // namespace

const std::array<Shares, most_movers>& place_shares(int curves) {
  static const auto all = [] {
    std::array<std::array<Shares, most_movers>, 16> made;
    for (int c = 0; c < 16; ++c)
      for (int mover = 0; mover < most_movers; ++mover)
        made[std::size_t(c)][std::size_t(mover)] = place_shares_of(mover, c);
    return made;
  }();
  return all[std::size_t(curves)];
}

const std::array<Shares, corner_movers>& color_shares() {
  static const auto all = [] {
    std::array<Shares, corner_movers> made;
    for (int mover = 0; mover < corner_movers; ++mover)
      made[std::size_t(mover)] = color_shares_of(mover);
    return made;
  }();
  return all;
}

void GridPoints::add(const Range& range) {
  const Range inside{std::max(range.first_row, 0), std::min(range.last_row, rows_),
                     std::max(range.first_column, 0), std::min(range.last_column, columns_)};
  if (inside.last_row < inside.first_row || inside.last_column < inside.first_column) return;
  for (int i = inside.first_row; i <= inside.last_row; ++i)
    for (int j = inside.first_column; j <= inside.last_column; ++j) has_[index(i, j)] = true;
  const bool is_first = bounds_.last_row < 0;
  bounds_ = is_first ? inside
                     : Range{std::min(bounds_.first_row, inside.first_row),
                             std::max(bounds_.last_row, inside.last_row),
                             std::min(bounds_.first_column, inside.first_column),
                             std::max(bounds_.last_column, inside.last_column)};
}

GridUnknowns::GridUnknowns(PlainGrid& grid, const GridPoints& points, bool with_colors)
    : points_(points), width_(std::size_t(grid.columns() + 1)), rows_(grid.rows()) {
  point_unknowns_.assign(std::size_t(rows_ + 1) * width_, -1);
  points.for_each([&](int i, int j) {
    if (!grid.is_fixed_point(i, j)) point_unknowns_[index(i, j)] = count_++;
  });
  for (const Along along : {Along::rows, Along::columns}) {
    tangents_[int(along)].resize(point_unknowns_.size());
    const bool is_row = along == Along::rows;
    for (int i = 0; i <= rows_ - !is_row; ++i)
      for (int j = 0; j <= grid.columns() - is_row; ++j)
        if (grid.bend(along, i, j))
          for (const int end : {0, 1}) number_tangent(grid, along, i, j, end);
  }
  columns_ = Columns(count_);
  if (with_colors && !grid.has_smooth_colors()) add_colors(grid);
  follow_chords(grid);
}

/// Smooth colours follow those of several points, and are left alone. Where something shines
/// through, the picture over white does not tell which colour looks alike over others, so the
/// colour stays.
void GridUnknowns::add_colors(const PlainGrid& grid) {
  points_.for_each([&](int i, int j) {
    if (grid.knot(i, j).color.a < 1 || point_unknowns_[index(i, j)] < 0) return;
    columns_.color[std::size_t(point_unknowns_[index(i, j)])] = columns_.count;
    columns_.count += 3;
  });
}

/// Numbers the tangent of a side at its start (`end` 0) or its end (1).
void GridUnknowns::number_tangent(const PlainGrid& grid, Along along, int row, int column,
                                  int end) {
  Tangent& tangent = tangents_[int(along)][index(row, column)][std::size_t(end)];
  const int down = along == Along::columns, right = along == Along::rows;
  const int i = row + end * down, j = column + end * right;
  const bool may_move = points_.contains(i, j) && point_unknowns_[index(i, j)] >= 0;
  tangent.kind = may_move ? Tangent::free : Tangent::stays;
  if (grid.is_fixed_side(along, row, column)) return;
  const bool is_inside = right ? j > 0 && j < grid.columns() : i > 0 && i < grid.rows();
  if (!is_inside || !grid.is_smooth(along, i, j)) {
    if (may_move) tangent.unknown = count_++;
    return;
  }
  // The side that goes on at the point: the one before, or the one after.
  const int other_i = end == 0 ? i - down : i, other_j = end == 0 ? j - right : j;
  const double length = glm::length((*grid.bend(along, row, column))[std::size_t(end)]);
  if (const PlainGrid::Bend& other = grid.bend(along, other_i, other_j)) {
    if (!may_move) return;
    const double both = length + glm::length((*other)[std::size_t(1 - end)]);
    tangent.factor = both > 0 ? 2 * length / both : 1;
    // The one before was numbered first.
    tangent.unknown =
        end == 0 ? tangents_[int(along)][index(other_i, other_j)][1].unknown : count_++;
    return;
  }
  tangent.from = index(other_i, other_j);
  tangent.to = index(other_i + down, other_j + right);
  const double chord = glm::length(position(grid, tangent.to) - position(grid, tangent.from));
  if (chord > 0) {
    tangent.kind = Tangent::follows_chord;
    tangent.factor = length / chord;
  } else if (may_move) {
    tangent.unknown = count_++;
  }
}

template <class Visit>
void GridUnknowns::for_each_tangent(const Visit& visit) const {
  for (const Along along : {Along::rows, Along::columns})
    for (int i = 0; i <= rows_; ++i)
      for (int j = 0; j < int(width_); ++j)
        for (std::size_t end = 0; end < 2; ++end) {
          const Tangent& tangent = tangents_[int(along)][index(i, j)][end];
          if (tangent.kind != Tangent::none) visit(along, i, j, end, tangent);
        }
}

void GridUnknowns::follow_chords(PlainGrid& grid) const {
  for_each_tangent([&](Along along, int i, int j, std::size_t end, const Tangent& t) {
    if (t.kind == Tangent::follows_chord)
      (*grid.bend(along, i, j))[end] = t.factor * (position(grid, t.to) - position(grid, t.from));
  });
}

std::vector<Influence> GridUnknowns::influences(int row, int column) const {
  std::array<const std::array<Tangent, 2>*, 4> sides;
  int curves = 0;
  for (int k = 0; k < 4; ++k) {
    const SideName name = side_name(row, column, k);
    sides[std::size_t(k)] = &tangents_[int(name.along)][index(name.row, name.column)];
    if ((*sides[std::size_t(k)])[0].kind != Tangent::none) curves |= 1 << k;
  }
  const auto& places = place_shares(curves);
  std::vector<Influence> result;
  const auto add = [&](int unknown, int mover, double factor) {
    if (unknown < 0) return;
    result.push_back({unknown, places[std::size_t(mover)], {}});
    for (double& share : result.back().place) share *= factor;
    if (mover < corner_movers && factor == 1)
      result.back().color = color_shares()[std::size_t(mover)];
  };
  const std::size_t corners[] = {index(row, column), index(row, column + 1),
                                 index(row + 1, column + 1), index(row + 1, column)};
  for (int k = 0; k < corner_movers; ++k) add(point_unknowns_[corners[k]], k, 1);
  for (int k = 0; k < 4; ++k)
    for (int end = 0; end < 2; ++end) {
      const Tangent& t = (*sides[std::size_t(k)])[std::size_t(end)];
      const int mover = tangent_mover(k, end);
      if (t.kind == Tangent::free) add(t.unknown, mover, t.factor);
      if (t.kind == Tangent::follows_chord) {
        add(point_unknowns_[t.to], mover, t.factor);
        add(point_unknowns_[t.from], mover, -t.factor);
      }
    }
  return result;
}

PlainGrid GridUnknowns::moved(const PlainGrid& grid, const Eigen::VectorXd& step,
                              const glm::dmat2& to_mesh, const std::vector<bool>& stays) const {
  PlainGrid result = grid;
  const auto place = [&](int unknown) {
    const int column = columns_.place[std::size_t(unknown)];
    return to_mesh * glm::dvec2(step(column), step(column + 1));
  };
  points_.for_each([&](int i, int j) {
    const int unknown = point_unknowns_[index(i, j)];
    if (unknown < 0 || stays[std::size_t(unknown)]) return;
    PlainGrid::Knot& knot = result.knot(i, j);
    knot.position += place(unknown);
    if (const int column = columns_.color[std::size_t(unknown)]; column >= 0)
      for (int k = 0; k < 3; ++k)
        knot.color[k] = std::clamp(knot.color[k] + step(column + k), 0.0, 1.0);
  });
  for_each_tangent([&](Along along, int i, int j, std::size_t end, const Tangent& t) {
    if (t.kind == Tangent::free && !stays[std::size_t(t.unknown)])
      (*result.bend(along, i, j))[end] += t.factor * place(t.unknown);
  });
  follow_chords(result);
  return result;
}

}  // namespace gradmesh
