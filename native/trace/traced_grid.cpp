#include "trace/traced_grid.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "base/clamped_int.h"
#include "trace/equations.h"
#include "trace/guide_stray.h"
#include "trace/line_changes.h"
#include "trace/line_fit.h"

namespace gradmesh {
namespace {

using Tell = std::function<void(const LineGrid&)>;

/// A target and smaller ones, each half as large as the one before.
using Pyramid = std::vector<TargetPicture>;

Pyramid pyramid(const TargetPicture& target) {
  constexpr int smallest = 16, most = 4;
  Pyramid levels{target};
  while (levels.size() < most &&
         std::min(levels.back().width, levels.back().height) >= 2 * smallest)
    levels.push_back(halved(levels.back()));
  return levels;
}

/// Returns the root of the mean of squares, in levels.
double rmse(double squares, const TargetPicture& target) {
  return std::sqrt(squares / (channels(target) * std::max(1.0, target.counted())));
}

/// Returns whether the first of two results is better.
bool is_better(const TracedGrid& a, const TracedGrid& b) {
  if (a.is_enough != b.is_enough) return a.is_enough;
  if (a.is_enough && a.grid.points() != b.grid.points()) return a.grid.points() < b.grid.points();
  return a.counts * a.squares < b.counts * b.squares;
}

/// Returns whether the first of two grown grids is likely to become the better one.
bool is_more_promising(const TracedGrid& a, const TracedGrid& b) {
  if (a.is_enough != b.is_enough) return a.is_enough;
  if (!a.is_enough) return a.counts * a.squares < b.counts * b.squares;
  // Squares are about inverse to points: the product says how many are left where all but enough
  // were taken out.
  return a.squares * a.grid.points() < b.squares * b.grid.points();
}

/// Returns the best of the results but the one at `left_out`; null if there is no other.
const TracedGrid* best_but(const std::vector<TracedGrid>& found, std::size_t left_out) {
  const TracedGrid* best = nullptr;
  for (std::size_t n = 0; n < found.size(); ++n)
    if (n != left_out && (!best || is_better(found[n], *best))) best = &found[n];
  return best;
}

/// A part of the work, and how many such parts there are: to grow or to finish one grid.
struct Turn {
  std::size_t number, count;
  /// The best that came of other beginnings so far; null if none has had a turn.
  const TracedGrid* rival;
};

/// At most how many lines and points a grid may have for a target: a patch has two pixels each way.
MostLines most_lines(const TargetPicture& target, int points) {
  return {std::max(1, target.height / 2), std::max(1, target.width / 2), points};
}

/// One beginning and what becomes of it: first it is grown, which is quick, then finished.
class Tracer {
 public:
  /// `number` is that of the beginning.
  Tracer(const Beginning& beginning, std::size_t number, const Pyramid& levels, int points,
         StopWatch& watch, const Tell& tell)
      : number_(number),
        counts_(beginning.counts),
        levels_(levels),
        is_enough_(beginning.is_enough),
        tell_(tell),
        watch_(watch),
        most_(most_lines(*beginning.target, points)),
        grid_(beginning.grid),
        level_(std::min<std::size_t>(2, levels.size() - 1)) {}

  /// Puts lines in, on the smallest pictures that show what they gain.
  void grow_up(Turn turn) {
    turn_ = turn;
    fit_unasked({15, 1e-3});
    while (!is_growing_over() && !(is_to_ask() && find_enough()) && grow()) fit_unasked(shortly);
    find_enough();
  }

  /// Fits on the whole picture, exchanges lines and takes out what is not needed.
  void finish(Turn turn) {
    turn_ = turn;
    while (level_ > 0 && !is_over()) {
      --level_;
      fit({8, 1e-3});
    }
    settle();
    while (is_enough_ && !is_over() && !is_enough() && grow()) fit(longer);
    while (!is_over() && take_out()) {
    }
  }

  /// Returns the grid so far, with its squares on the whole picture.
  TracedGrid result() {
    return {grid_.in_whole_levels(), number_, squares_on_whole(), is_enough(), counts_};
  }

 private:
  struct State {
    LineGrid grid;
    std::size_t level;
    double squares;
  };

  static constexpr FitLength shortly{3, 1e-3}, longer{10, 1e-3}, to_the_end{40, 5e-4};

  const TargetPicture& target() const { return levels_[level_]; }

  void fit(FitLength length) { squares_ = fit_lines(grid_, target(), evenness_, length); }

  /// Reports how far the turn has come, in points, and the best grid so far. Returns true if the
  /// run has to stop.
  bool is_over_at(std::size_t done, const LineGrid& best, double error) {
    if (tell_) tell_(best);
    const auto points = std::size_t(most_.points);
    return watch_.should_stop({turn_.number * points + done, turn_.count * points,
                               best.rows() * best.columns(), error / 255, best.points()});
  }

  bool is_over_at(std::size_t done, const TracedGrid& best) {
    return is_over_at(done, best.grid, rmse(best.squares, levels_.front()));
  }

  /// Reports how far the grid has grown. It is worse than one that is grown, so that it does not
  /// have to be measured on the whole picture as long as there is such a one.
  bool is_growing_over() {
    const auto done = std::size_t(grid_.points());
    return turn_.rival ? is_over_at(done, *turn_.rival)
                       : is_over_at(done, grid_, rmse(squares_, target()));
  }

  /// Reports how far the grid is finished. How many steps that takes is not known: each goes an
  /// eighth of the way that is left.
  bool is_over() {
    finished_ += (std::size_t(most_.points) - finished_) / 8;
    const TracedGrid own{grid_.in_whole_levels(), number_, squares_on_whole(), false, counts_};
    return is_over_at(finished_, is_behind(own) ? *turn_.rival : own);
  }

  /// Returns whether the rival is better. A grid of more squares counts as enough only if the rival
  /// is: to ask each time would make a run a tenth longer.
  bool is_behind(TracedGrid own) {
    if (!turn_.rival) return false;
    own.is_enough = turn_.rival->is_enough;
    return is_better(*turn_.rival, own) || (own.is_enough && !is_enough());
  }

  double squares_on_whole() const {
    return level_ > 0 ? squares_of(grid_, levels_.front()) : squares_;
  }

  bool is_enough() {
    constexpr double hardly_seen = 0.3;
    if (!is_enough_) return rmse(squares_, target()) < hardly_seen;
    // The grid is painted for the answer, which is asked for more than once.
    if (!judged_ || judged_->first != grid_)
      judged_ = std::pair(grid_, is_enough_(grid_.in_whole_levels()));
    return judged_->second;
  }

  void fit_unasked(FitLength length) {
    fit(length);
    unasked_.push_back({grid_, level_, squares_});
  }

  /// Returns whether it is time to ask if the grid is enough: to paint it takes longer than to put
  /// a line in.
  bool is_to_ask() {
    constexpr double more = 1.25;
    if (is_enough_ && grid_.points() < more * asked_points_) return false;
    asked_points_ = grid_.points();
    return true;
  }

  /// Returns whether the grid is enough, and goes back to the first one that is.
  bool find_enough() {
    const std::vector<State> states = std::exchange(unasked_, {});
    const bool found = is_enough();
    for (std::size_t n = 0; found && n < states.size(); ++n) {
      level_ = states[n].level;
      restore(states[n].grid, states[n].squares);
      if (is_enough()) break;
    }
    return found;
  }

  /// Puts the best line in. Returns false if there is none that helps.
  bool grow() {
    refine_level();
    return grow(most_);
  }

  bool grow(const MostLines& most) {
    const std::optional<LineChange> line = best_new_line(grid_, target(), most);
    if (!line || !(line->squares > 0)) return false;
    grid_ = grid_.with_line(line->along, line->number);
    return true;
  }

  /// Goes to larger pictures where patches have become small.
  void refine_level() {
    constexpr double least_pixels = 6;
    while (level_ > 0 && mean_side() < least_pixels) {
      --level_;
      fit({6, 1e-3});
    }
  }

  /// The mean length of a patch's sides in pixels.
  double mean_side() const {
    return std::sqrt(double(target().samples()) / (grid_.rows() * grid_.columns()));
  }

  /// Fits for long, with less and less that holds the lines even.
  void settle() {
    constexpr int times = 4, most_exchanges = 6;
    if (!is_over()) fit(to_the_end);
    for (int i = 0; i < most_exchanges && !is_over() && exchange(); ++i) {
    }
    for (int i = 0; i < times && !is_over(); ++i) {
      evenness_ = evenness_.times(0.25);
      fit({6, 1e-3});
    }
    if (!is_over()) fit(to_the_end);
  }

  /// Takes the cheapest line out and puts lines in where they help more now. Returns false if that
  /// was no better, and nothing has changed.
  bool exchange() {
    constexpr double little = 1e-3;
    const LineGrid before = grid_;
    const double squares = squares_, strays = stray_squares(before, target());
    MostLines most = most_;
    if (is_enough()) most.points = before.points();
    if (!without_cheapest()) return false;
    fit(shortly);
    while (grow(most)) fit(shortly);
    fit(longer);
    const double now = squares_ + stray_squares(grid_, target());
    return now < (1 - little) * (squares + strays) || restore(before, squares);
  }

  /// Takes the cheapest line out. Returns false if the grid is not enough then, and nothing has
  /// changed.
  bool take_out() {
    const LineGrid before = grid_;
    const double squares = squares_;
    if (!is_enough() || !without_cheapest()) return false;
    fit(longer);
    return is_enough() || restore(before, squares);
  }

  bool without_cheapest() {
    const std::optional<LineChange> line = cheapest_line(grid_, target());
    if (line) grid_ = grid_.without_line(line->along, line->number);
    return line.has_value();
  }

  bool restore(const LineGrid& grid, double squares) {
    grid_ = grid;
    squares_ = squares;
    return false;
  }

  const std::size_t number_;
  const double counts_;
  const Pyramid& levels_;
  const std::function<bool(const LineGrid&)>& is_enough_;
  const Tell& tell_;
  StopWatch& watch_;
  const MostLines most_;
  LineGrid grid_;
  std::size_t level_;
  Turn turn_{0, 1, nullptr};
  /// How far finishing has come, in points.
  std::size_t finished_ = 0;
  Evenness evenness_;
  double squares_ = 0;
  /// How the grid was since it was last asked whether it is enough, and its points then.
  std::vector<State> unasked_;
  int asked_points_ = 0;
  /// The last grid of which it was asked whether it is enough, and the answer.
  std::optional<std::pair<LineGrid, bool>> judged_;
};

}  // namespace

std::vector<LineGrid> even_grids(const TargetPicture& target, glm::dvec2 size, int points) {
  constexpr int most_at_first = 16;
  const MostLines most = most_lines(target, points);
  std::vector<LineGrid> grids;
  const double shape = std::sqrt(size.x / size.y);
  for (const double across : {6.0, 5.0, 3.0}) {
    int columns = clamped_int(across * shape + 0.5, 1, std::min(most_at_first, most.columns));
    int rows = clamped_int(across / shape + 0.5, 1, std::min(most_at_first, most.rows));
    while ((rows + 1) * (columns + 1) > points) rows >= columns ? --rows : --columns;
    grids.emplace_back(rows, columns, size);
  }
  return grids;
}

TracedGrid traced_grid(const std::vector<Beginning>& beginnings, int points, StopWatch& watch,
                       const Tell& tell) {
  // To finish all of them takes twice as long, and the best one was among the first two.
  const std::size_t most_finished = std::min<std::size_t>(2, beginnings.size());
  const std::size_t turns = beginnings.size() + most_finished;
  std::map<const TargetPicture*, Pyramid> pyramids;
  std::vector<Tracer> tracers;
  std::vector<TracedGrid> found;
  for (std::size_t n = 0; n < beginnings.size() && (n == 0 || !watch.is_over()); ++n) {
    const TargetPicture* target = beginnings[n].target;
    if (!pyramids.contains(target)) pyramids[target] = pyramid(*target);
    tracers.emplace_back(beginnings[n], n, pyramids[target], points, watch, tell);
    tracers.back().grow_up({n, turns, best_but(found, n)});
    found.push_back(tracers.back().result());
  }
  std::ranges::stable_sort(found, is_more_promising);
  for (std::size_t n = 0; n < most_finished && !watch.is_over(); ++n) {
    Tracer& tracer = tracers[found[n].beginning];
    tracer.finish({beginnings.size() + n, turns, best_but(found, n)});
    found[n] = tracer.result();
  }
  return *best_but(found, found.size());
}

}  // namespace gradmesh
