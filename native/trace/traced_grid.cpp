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

/// Returns whether the first of two results is better, where the squares of each count so many
/// times.
bool is_better(const TracedGrid& a, double a_counts, const TracedGrid& b, double b_counts) {
  if (a.is_enough != b.is_enough) return a.is_enough;
  if (a.is_enough && a.grid.points() != b.grid.points()) return a.grid.points() < b.grid.points();
  return a_counts * a.squares < b_counts * b.squares;
}

/// Returns whether the first of two grown grids is likely to become the better one, where the
/// squares of each count so many times.
bool is_more_promising(const TracedGrid& a, double a_counts, const TracedGrid& b, double b_counts) {
  if (a.is_enough != b.is_enough) return a.is_enough;
  if (!a.is_enough) return a_counts * a.squares < b_counts * b.squares;
  // Squares are about inverse to points: the product says how many are left where all but enough
  // were taken out.
  return a.squares * a.grid.points() < b.squares * b.grid.points();
}

/// A part of the work, and how many such parts there are: to grow or to finish one grid.
struct Turn {
  std::size_t number, count;
};

/// At most how many lines and points a grid may have for a target: a patch has two pixels each way.
MostLines most_lines(const TargetPicture& target, int points) {
  return {std::max(1, target.height / 2), std::max(1, target.width / 2), points};
}

/// One beginning and what becomes of it: first it is grown, which is quick, then finished.
class Tracer {
 public:
  Tracer(const Beginning& beginning, const Pyramid& levels, int points, StopWatch& watch)
      : levels_(levels),
        is_enough_(beginning.is_enough),
        tell_(beginning.tell),
        watch_(watch),
        most_(most_lines(*beginning.target, points)),
        grid_(beginning.grid),
        level_(std::min<std::size_t>(2, levels.size() - 1)) {}

  /// Puts lines in, on the smallest pictures that show what they gain.
  void grow_up(Turn turn) {
    turn_ = turn;
    fit_unasked({15, 1e-3});
    while (!is_over_at(std::size_t(grid_.points())) && !(is_to_ask() && find_enough()) && grow())
      fit_unasked(shortly);
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
  TracedGrid result(std::size_t beginning) {
    const double squares = level_ > 0 ? squares_of(grid_, levels_.front()) : squares_;
    return {grid_.in_whole_levels(), beginning, squares, is_enough()};
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

  /// Reports how far the turn has come, in points. Returns true if the run has to stop.
  bool is_over_at(std::size_t done) {
    if (tell_) tell_(grid_);
    const auto points = std::size_t(most_.points);
    return watch_.should_stop({turn_.number * points + done, turn_.count * points,
                               grid_.rows() * grid_.columns(), rmse(squares_, target()) / 255,
                               grid_.points()});
  }

  /// The same while the grid is finished. How many steps that takes is not known: each goes an
  /// eighth of the way that is left.
  bool is_over() {
    finished_ += (std::size_t(most_.points) - finished_) / 8;
    return is_over_at(finished_);
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

  const Pyramid& levels_;
  const std::function<bool(const LineGrid&)>& is_enough_;
  const std::function<void(const LineGrid&)>& tell_;
  StopWatch& watch_;
  const MostLines most_;
  LineGrid grid_;
  std::size_t level_;
  Turn turn_{0, 1};
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

TracedGrid traced_grid(const std::vector<Beginning>& beginnings, int points, StopWatch& watch) {
  // To finish all of them takes twice as long, and the best one was among the first two.
  const std::size_t most_finished = std::min<std::size_t>(2, beginnings.size());
  const std::size_t turns = beginnings.size() + most_finished;
  std::map<const TargetPicture*, Pyramid> pyramids;
  std::vector<Tracer> tracers;
  std::vector<TracedGrid> found;
  for (std::size_t n = 0; n < beginnings.size() && (n == 0 || !watch.is_over()); ++n) {
    const TargetPicture* target = beginnings[n].target;
    if (!pyramids.contains(target)) pyramids[target] = pyramid(*target);
    tracers.emplace_back(beginnings[n], pyramids[target], points, watch);
    tracers.back().grow_up({n, turns});
    found.push_back(tracers.back().result(n));
  }
  const auto by = [&](auto is_first) {
    return [&beginnings, is_first](const TracedGrid& a, const TracedGrid& b) {
      return is_first(a, beginnings[a.beginning].counts, b, beginnings[b.beginning].counts);
    };
  };
  std::ranges::stable_sort(found, by(is_more_promising));
  for (std::size_t n = 0; n < most_finished && !watch.is_over(); ++n) {
    Tracer& tracer = tracers[found[n].beginning];
    tracer.finish({beginnings.size() + n, turns});
    found[n] = tracer.result(found[n].beginning);
  }
  return *std::ranges::min_element(found, by(is_better));
}

}  // namespace gradmesh
