#include "plain/grid_fit.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "base/parallel.h"
#include "fit/equations.h"
#include "raster/folds.h"

namespace gradmesh {
namespace {

/// A mean of FLIP counts a difference about as much as its size, not as its square.
constexpr Robustness by_size = {.scale = 0.02, .power = 0.5};

/// What moves a patch: its corners and, for each side that is a curve, the tangents of the grid's
/// side at its two ends.
constexpr int corners = 4, most_movers = corners + 8;

/// Returns the grid's tangents of a side of a patch as the side itself has them, which runs
/// clockwise: the bottom and the left against the grid.
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

/// Returns how the control vectors of a Coons patch move with each mover, which is linear;
/// `is_bent` says which sides are curves. Movers that the patch does not have are zero.
std::array<std::array<double, 16>, most_movers> movements(const std::array<bool, 4>& is_bent) {
  std::array<std::array<double, 16>, most_movers> result{};
  for (int mover = 0; mover < most_movers; ++mover) {
    std::array<Cubic<Value>, 4> sides;
    const auto corner = [&](int k) { return glm::dvec2(k % 4 == mover ? 1 : 0, 0); };
    for (int k = 0; k < 4; ++k) {
      // As the grid has them: from left to right or from top to bottom.
      const glm::dvec2 chord = (k >= 2 ? -1.0 : 1.0) * (corner(k + 1) - corner(k));
      std::array<glm::dvec2, 2> tangents = {chord, chord};
      if (is_bent[std::size_t(k)])
        for (int end = 0; end < 2; ++end)
          tangents[std::size_t(end)] = glm::dvec2(mover == corners + 2 * k + end ? 1 : 0, 0);
      sides[std::size_t(k)] = clockwise(k, corner(k), tangents, corner(k + 1));
    }
    Patch patch = patch_from_sides(sides, {});
    make_coons(patch);
    for (std::size_t c = 0; c < 16; ++c)
      result[std::size_t(mover)][c] = patch.c[c / 4][c % 4].position.x;
  }
  return result;
}

const std::array<std::array<double, 16>, most_movers>& movements_of(int bent_sides) {
  static const auto all = [] {
    std::array<std::array<std::array<double, 16>, most_movers>, 16> made;
    for (int sides = 0; sides < 16; ++sides)
      made[std::size_t(sides)] =
          movements({(sides & 1) != 0, (sides & 2) != 0, (sides & 4) != 0, (sides & 8) != 0});
    return made;
  }();
  return all[std::size_t(bent_sides)];
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

/// Returns which sides of a patch are on the boundary.
std::array<bool, 4> outlines(const PlainGrid& grid, int row, int column) {
  return {row == 0, column + 1 == grid.columns(), row + 1 == grid.rows(), column == 0};
}

class GridFit {
 public:
  GridFit(PlainGrid& grid, const FitTarget& target)
      : grid_(grid), target_(target), to_mesh_(glm::inverse(target.frame().to_pixels.linear)) {
    number_unknowns();
    follow_chords(grid_);
  }

  double run(int steps) {
    double damping = first_damping;
    Equations now = equations(grid_);
    while (steps-- > 0) {
      const Eigen::VectorXd step = solve(now.parts, Eigen::VectorXd::Constant(2 * count_, damping));
      if (!step.allFinite()) break;
      PlainGrid moved = without_new_folds(step);
      Equations then = equations(moved);
      if (then.squares < now.squares) {
        const double drop = now.squares - then.squares;
        grid_ = std::move(moved);
        now = std::move(then);
        damping = std::max(least_damping, damping / fall);
        if (drop < little * now.squares) break;
      } else {
        damping *= rise;
      }
    }
    return now.squares;
  }

 private:
  static constexpr double first_damping = 1e-3, least_damping = 1e-4, fall = 4, rise = 20;
  /// A step that lowers the sum by less than this share of it is the last.
  static constexpr double little = 2e-3;

  struct Equations {
    std::vector<NormalEquations> parts;
    double squares = 0;
  };

  /// A tangent of a side that is a curve, at one of its ends. A line that was smooth at a point
  /// stays so: where both of its sides are curves their tangents move together, each by its own
  /// factor, and where the other side is straight the tangent is its chord times the factor.
  struct Tangent {
    enum Kind { none, free, follows_chord };
    Kind kind = none;
    int unknown = -1;
    double factor = 1;
    /// follows_chord: the points between which the chord runs.
    std::size_t from = 0, to = 0;
  };

  void number_unknowns() {
    count_ = int(std::size_t(grid_.rows() + 1) * width());
    for (const Along along : {Along::rows, Along::columns}) {
      tangents_[int(along)].resize(std::size_t(count_of_points()));
      const bool is_row = along == Along::rows;
      for (int i = 0; i <= grid_.rows() - !is_row; ++i)
        for (int j = 0; j <= grid_.columns() - is_row; ++j)
          if (grid_.bend(along, i, j)) {
            number_tangent(along, i, j, 0);
            number_tangent(along, i, j, 1);
          }
    }
  }

  int count_of_points() const { return (grid_.rows() + 1) * (grid_.columns() + 1); }

  /// Numbers the tangent of a side at its start (`end` 0) or its end (1).
  void number_tangent(Along along, int row, int column, int end) {
    Tangent& tangent = tangents_[int(along)][index(row, column)][std::size_t(end)];
    tangent.kind = Tangent::free;
    const int down = along == Along::columns, right = along == Along::rows;
    const int i = row + end * down, j = column + end * right;
    const bool is_inside = right ? j > 0 && j < grid_.columns() : i > 0 && i < grid_.rows();
    if (!is_inside || !grid_.is_smooth(along, i, j)) {
      tangent.unknown = count_++;
      return;
    }
    // The side that goes on at the point: the one before, or the one after.
    const int other_i = end == 0 ? i - down : i, other_j = end == 0 ? j - right : j;
    const double length = glm::length((*grid_.bend(along, row, column))[std::size_t(end)]);
    if (const PlainGrid::Bend& other = grid_.bend(along, other_i, other_j)) {
      const double other_length = glm::length((*other)[std::size_t(1 - end)]);
      const double both = length + other_length;
      tangent.factor = both > 0 ? 2 * length / both : 1;
      // The one before was numbered first.
      tangent.unknown =
          end == 0 ? tangents_[int(along)][index(other_i, other_j)][1].unknown : count_++;
      return;
    }
    tangent.from = index(other_i, other_j);
    tangent.to = index(other_i + down, other_j + right);
    const double chord = glm::length(position(grid_, tangent.to) - position(grid_, tangent.from));
    if (chord == 0) {
      tangent.unknown = count_++;
      return;
    }
    tangent.kind = Tangent::follows_chord;
    tangent.factor = length / chord;
  }

  glm::dvec2 position(const PlainGrid& grid, std::size_t point) const {
    return grid.knot(int(point / width()), int(point % width())).position;
  }

  template <class Visit>
  void for_each_tangent(const Visit& visit) const {
    for (const Along along : {Along::rows, Along::columns})
      for (int i = 0; i <= grid_.rows(); ++i)
        for (int j = 0; j <= grid_.columns(); ++j)
          for (std::size_t end = 0; end < 2; ++end)
            if (const Tangent& t = tangents_[int(along)][index(i, j)][end]; t.kind != Tangent::none)
              visit(along, i, j, end, t);
  }

  void follow_chords(PlainGrid& grid) const {
    for_each_tangent([&](Along along, int i, int j, std::size_t end, const Tangent& t) {
      if (t.kind == Tangent::follows_chord)
        (*grid.bend(along, i, j))[end] = t.factor * (position(grid, t.to) - position(grid, t.from));
    });
  }

  std::size_t width() const { return std::size_t(grid_.columns() + 1); }
  std::size_t index(int row, int column) const {
    return std::size_t(row) * width() + std::size_t(column);
  }

  std::vector<Influence> influences(int row, int column) const {
    std::array<const std::array<Tangent, 2>*, 4> sides;
    int bent_sides = 0;
    for (int k = 0; k < 4; ++k) {
      const SideName name = side_name(row, column, k);
      sides[std::size_t(k)] = &tangents_[int(name.along)][index(name.row, name.column)];
      if ((*sides[std::size_t(k)])[0].kind != Tangent::none) bent_sides |= 1 << k;
    }
    const auto& moves = movements_of(bent_sides);
    const std::size_t knots[] = {index(row, column), index(row, column + 1),
                                 index(row + 1, column + 1), index(row + 1, column)};
    std::vector<Influence> result;
    const auto add = [&](std::size_t unknown, std::size_t mover, double factor) {
      result.push_back({int(unknown), moves[mover], {}});
      for (double& share : result.back().place) share *= factor;
    };
    for (std::size_t k = 0; k < 4; ++k) add(knots[k], k, 1);
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t end = 0; end < 2; ++end) {
        const Tangent& t = (*sides[k])[end];
        const std::size_t mover = corners + 2 * k + end;
        if (t.kind == Tangent::free) add(std::size_t(t.unknown), mover, t.factor);
        if (t.kind == Tangent::follows_chord) {
          add(t.to, mover, t.factor);
          add(t.from, mover, -t.factor);
        }
      }
    return result;
  }

  Equations equations(const PlainGrid& grid) const {
    Equations result;
    const Columns columns(count_);
    const int across = grid.columns();
    result.parts.resize(std::size_t(grid.rows() * across));
    parallel_for(result.parts.size(), [&](std::size_t n) {
      const int i = int(n) / across, j = int(n) % across;
      result.parts[n] = normal_equations(grid.patch(i, j), influences(i, j), outlines(grid, i, j),
                                         columns, target_, by_size);
    });
    for (const NormalEquations& part : result.parts) result.squares += part.squares;
    return result;
  }

  /// Returns the grid after a step, without the moves at patches that would begin to fold.
  PlainGrid without_new_folds(const Eigen::VectorXd& step) const {
    std::vector<bool> stays(std::size_t(count_), false);
    constexpr int most_attempts = 4;
    for (int attempt = 0;; ++attempt) {
      PlainGrid moved = after(step, stays);
      bool folds = false;
      for (int i = 0; i < grid_.rows(); ++i)
        for (int j = 0; j < grid_.columns(); ++j)
          if (may_fold(moved.patch(i, j)) && !may_fold(grid_.patch(i, j))) {
            folds = true;
            for (const Influence& by : influences(i, j)) stays[std::size_t(by.unknown)] = true;
          }
      if (!folds) return moved;
      if (attempt == most_attempts) return grid_;
    }
  }

  PlainGrid after(const Eigen::VectorXd& step, const std::vector<bool>& stays) const {
    PlainGrid moved = grid_;
    const auto by = [&](int unknown) {
      if (stays[std::size_t(unknown)]) return glm::dvec2(0.0);
      return to_mesh_ * glm::dvec2(step(2 * unknown), step(2 * unknown + 1));
    };
    for (int i = 0; i <= grid_.rows(); ++i)
      for (int j = 0; j <= grid_.columns(); ++j) moved.knot(i, j).position += by(int(index(i, j)));
    for_each_tangent([&](Along along, int i, int j, std::size_t end, const Tangent& t) {
      if (t.kind == Tangent::free) (*moved.bend(along, i, j))[end] += t.factor * by(t.unknown);
    });
    follow_chords(moved);
    return moved;
  }

  PlainGrid& grid_;
  const FitTarget& target_;
  const glm::dmat2 to_mesh_;
  /// By side and end. The unknowns are the points, by index(), and then the free tangents.
  std::array<std::vector<std::array<Tangent, 2>>, 2> tangents_;
  int count_ = 0;
};

}  // namespace

double patch_squares(const PlainGrid& grid, int row, int column, const FitTarget& target) {
  return normal_equations(grid.patch(row, column), {}, outlines(grid, row, column), Columns(0),
                          target, by_size)
      .squares;
}

double fit_grid(PlainGrid& grid, const FitTarget& target, int steps) {
  return GridFit(grid, target).run(steps);
}

}  // namespace gradmesh
