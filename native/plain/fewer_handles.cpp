#include "plain/fewer_handles.h"

#include <algorithm>
#include <glm/common.hpp>
#include <limits>
#include <span>

#include "base/parallel.h"
#include "plain/grid_fit.h"

namespace gradmesh {
namespace {

/// A side of the grid, by the point at which it begins.
struct Side {
  Along along;
  int row, column;

  bool operator==(const Side&) const = default;
};

std::vector<Side> curved_sides(const PlainGrid& grid) {
  std::vector<Side> sides;
  for (const Along along : {Along::rows, Along::columns})
    for (int i = 0; i <= grid.rows() - (along == Along::columns); ++i)
      for (int j = 0; j <= grid.columns() - (along == Along::rows); ++j)
        if (grid.bend(along, i, j)) sides.push_back({along, i, j});
  return sides;
}

/// A way to make a grid simpler: sides that become straight, or a line that is taken out.
struct Step {
  std::vector<Side> sides;
  Along along = Along::rows;
  int line = 0;

  bool takes_line() const { return line > 0; }
};

void make(const Step& step, PlainGrid& grid) {
  for (const Side& side : step.sides) grid.bend(side.along, side.row, side.column).reset();
  if (step.takes_line()) grid.take_out(step.along, step.line);
}

/// A corner of a line that was smooth is seen from about here: the sine of its angle times the
/// difference of colour to the lines beside it.
constexpr double seen_corner = 0.15;

/// Returns how much is seen of the corner at a point of a line between two straight sides, as of
/// seen_corner; 0 where there is none, or where the line was not smooth.
double corner_at(const PlainGrid& grid, Along along, int row, int column) {
  const int down = along == Along::columns, right = along == Along::rows;
  const bool is_inside =
      right ? column > 0 && column < grid.columns() : row > 0 && row < grid.rows();
  if (!is_inside || !grid.is_smooth(along, row, column) || grid.bend(along, row, column) ||
      grid.bend(along, row - down, column - right))
    return 0;
  double contrast = 0;
  for (const int beside : {-1, 1}) {
    const int i = row + beside * right, j = column + beside * down;
    if (i < 0 || j < 0 || i > grid.rows() || j > grid.columns()) continue;
    const glm::dvec4 d = glm::abs(grid.knot(i, j).color - grid.knot(row, column).color);
    contrast = std::max({contrast, d.r, d.g, d.b, d.a});
  }
  return contrast * grid.turn(along, row, column);
}

double largest_corner(const PlainGrid& grid) {
  double most = 0;
  for (const Along along : {Along::rows, Along::columns})
    for (int i = 0; i <= grid.rows(); ++i)
      for (int j = 0; j <= grid.columns(); ++j) most = std::max(most, corner_at(grid, along, i, j));
  return most;
}

class Selection {
 public:
  Selection(PlainGrid start, double error, const GridTask& task, StopWatch& watch)
      : grid_(std::move(start)),
        error_(error),
        task_(task),
        watch_(watch),
        first_handles_(grid_.handles()) {}

  /// Passes go on as long as steps are made after others were found to be too much, which may keep
  /// to epsilon now that the points have been fitted anew.
  void run() {
    do pass();
    while (made_ > made_when_too_much_ && !is_over_);
  }

  const PlainGrid& grid() const { return grid_; }
  double error() const { return error_; }
  int evaluations() const { return evaluations_; }

 private:
  /// A step, and the grid that it leads to from the one of when `made_` was `priced_at`.
  struct Candidate {
    Step step;
    /// By how much the error rises for each handle saved.
    double price;
    int priced_at = -1;
    GridTask::Measured measured = {};
    std::optional<PlainGrid> grid = std::nullopt;
  };

  /// Prices that are found at the same time: fixed, so that the result does not depend on the
  /// number of threads.
  static constexpr std::size_t at_once = 2;
  /// Of the sides that may become straight, one in so many does in one step; and where these are
  /// too many, one in so many of them.
  static constexpr std::size_t share_at_once = 4;
  /// After so many single sides that were too much, one after the other, no more are tried in a
  /// pass: those that are left change the picture more.
  static constexpr int most_in_a_row = 40;

  void pass() {
    list_lines();
    too_much_.clear();
    too_much_in_a_row_ = 0;
    made_when_too_much_ = std::numeric_limits<int>::max();
    most_sides_ = std::numeric_limits<std::size_t>::max();
    while (!should_stop()) {
      propose_sides();
      if (candidates_.empty()) break;
      std::ranges::stable_sort(candidates_, {}, &Candidate::price);
      const Candidate& best = candidates_.front();
      if (best.priced_at != made_)
        price(std::span(candidates_).first(std::min(candidates_.size(), at_once)));
      else if (best.measured.keeps)
        accept_first();
      else
        drop_first();
    }
  }

  void list_lines() {
    candidates_.clear();
    sides_proposed_at_ = -1;
    // Lines are first looked at when what is cheaper than epsilon is for all handles has been made.
    const double price = task_.epsilon / first_handles_;
    for (int i = 1; i < grid_.rows(); ++i) candidates_.push_back({{{}, Along::rows, i}, price});
    for (int j = 1; j < grid_.columns(); ++j)
      candidates_.push_back({{{}, Along::columns, j}, price});
  }

  /// Sees to it that one candidate makes sides straight: of all that may still become so, the
  /// cheapest by the sums of squares before anything is fitted, and of these a part at a time.
  void propose_sides() {
    if (sides_proposed_at_ == made_) return;
    sides_proposed_at_ = made_;
    std::erase_if(candidates_, [](const Candidate& c) { return !c.step.takes_line(); });
    if (too_much_in_a_row_ >= most_in_a_row) return;
    std::vector<Side> sides = curved_sides(grid_);
    std::erase_if(sides, [&](const Side& side) {
      return std::ranges::find(too_much_, side) != too_much_.end() || makes_corner(side);
    });
    if (sides.empty()) return;
    std::vector<std::pair<double, std::size_t>> order(sides.size());
    parallel_for(sides.size(), [&](std::size_t n) { order[n] = {rise_if_straight(sides[n]), n}; });
    std::ranges::sort(order);
    const std::size_t count =
        std::min(most_sides_, (sides.size() + share_at_once - 1) / share_at_once);
    Step step;
    for (std::size_t n = 0; n < count; ++n) step.sides.push_back(sides[order[n].second]);
    candidates_.push_back({std::move(step), -std::numeric_limits<double>::infinity()});
  }

  /// Returns true if a line that was smooth would have a corner that is seen at one end of the side
  /// if the side became straight. There is none where the other side stays a curve, which then
  /// follows.
  bool makes_corner(const Side& side) const {
    PlainGrid straight = grid_;
    straight.bend(side.along, side.row, side.column).reset();
    const int down = side.along == Along::columns, right = side.along == Along::rows;
    return corner_at(straight, side.along, side.row, side.column) > seen_corner ||
           corner_at(straight, side.along, side.row + down, side.column + right) > seen_corner;
  }

  /// Returns by how much the sum of squares rises if a side becomes straight and nothing is fitted.
  double rise_if_straight(const Side& side) const {
    PlainGrid straight = grid_;
    straight.bend(side.along, side.row, side.column).reset();
    const int above = side.along == Along::rows, left = side.along == Along::columns;
    double rise = 0;
    for (const auto& [i, j] :
         {std::pair(side.row, side.column), std::pair(side.row - above, side.column - left)})
      if (i >= 0 && j >= 0 && i < grid_.rows() && j < grid_.columns())
        rise +=
            patch_squares(straight, i, j, task_.coarse) - patch_squares(grid_, i, j, task_.coarse);
    return rise;
  }

  void price(std::span<Candidate> candidates) {
    evaluations_ += int(candidates.size());
    parallel_for(candidates.size(), [&](std::size_t n) {
      Candidate& c = candidates[n];
      if (c.priced_at == made_) return;
      constexpr int steps = 2;
      PlainGrid grid = grid_;
      make(c.step, grid);
      fit_grid(grid, task_.target, steps);
      c.measured = task_.measure(grid);
      if (largest_corner(grid) > most_corner_) c.measured.keeps = false;
      c.price = (c.measured.error - error_) / (grid_.handles() - grid.handles());
      c.priced_at = made_;
      c.grid = std::move(grid);
    });
  }

  void accept_first() {
    Candidate& first = candidates_.front();
    const Step step = std::move(first.step);
    grid_ = std::move(*first.grid);
    error_ = first.measured.error;
    ++made_;
    too_much_in_a_row_ = 0;
    candidates_.erase(candidates_.begin());
    if (step.takes_line()) renumber_without(step);
  }

  void renumber_without(const Step& gone) {
    for (Candidate& c : candidates_)
      if (c.step.along == gone.along && c.step.line > gone.line) --c.step.line;
    std::erase_if(too_much_, [&](Side& side) {
      int& at = gone.along == Along::rows ? side.row : side.column;
      if (at > gone.line) --at;
      // The sides beside the line are others now.
      return at == gone.line || at == gone.line - 1;
    });
  }

  /// Gives up the first candidate; of several sides fewer are tried.
  void drop_first() {
    made_when_too_much_ = std::min(made_when_too_much_, made_);
    const Step& step = candidates_.front().step;
    if (!step.takes_line()) {
      sides_proposed_at_ = -1;
      if (step.sides.size() > 1) {
        most_sides_ = std::max<std::size_t>(1, step.sides.size() / share_at_once);
      } else {
        too_much_.push_back(step.sides.front());
        ++too_much_in_a_row_;
      }
    }
    candidates_.erase(candidates_.begin());
  }

  bool should_stop() {
    const int handles = grid_.handles();
    is_over_ =
        watch_.should_stop({std::size_t(first_handles_ - handles), std::size_t(first_handles_),
                            grid_.rows() * grid_.columns(), error_});
    return is_over_;
  }

  PlainGrid grid_;
  double error_;
  /// Fits after a step may turn corners a little further.
  const double most_corner_ = std::max(1.5 * seen_corner, largest_corner(grid_));
  const GridTask& task_;
  StopWatch& watch_;
  const int first_handles_;
  std::vector<Candidate> candidates_;
  /// Sides that cost too much to be straight, in this pass.
  std::vector<Side> too_much_;
  /// The most sides that are made straight at once, in this pass.
  std::size_t most_sides_ = 0;
  /// The number of steps that were made, and how many that were when sides were proposed.
  int made_ = 0, sides_proposed_at_ = -1;
  /// The number that had been made when the first step of this pass was found to be too much.
  int made_when_too_much_ = 0;
  int too_much_in_a_row_ = 0;
  int evaluations_ = 0;
  bool is_over_ = false;
};

}  // namespace

std::optional<SimplerGrid> with_fewer_handles(const PlainGrid& grid, const GridTask& task,
                                              StopWatch& watch) {
  PlainGrid start = grid;
  GridTask::Measured measured = task.measure(start);
  if (!measured.keeps) {
    // The twists that are lost.
    constexpr int steps = 8;
    fit_grid(start, task.target, steps);
    measured = task.measure(start);
    if (!measured.keeps) return std::nullopt;
  }
  Selection selection(std::move(start), measured.error, task, watch);
  selection.run();
  if (selection.grid().handles() >= grid.handles()) return std::nullopt;
  return SimplerGrid{selection.grid(), selection.error(), selection.evaluations()};
}

}  // namespace gradmesh
