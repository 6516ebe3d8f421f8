#include "trace/traced_grid.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "base/clamped_int.h"
#include "base/parallel.h"
#include "base/waiting_caller.h"
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

/// Works on several beginnings at the same time, while the thread that waits tells the watch how
/// far that is, and shows what a stop would keep: the best that was grown, or else the first
/// beginning.
class Telling {
 public:
  /// `total` is how far all work goes, in points.
  Telling(std::size_t beginnings, std::size_t total, StopWatch& watch, const Tell& tell)
      : watch_(watch), tell_(tell), total_(total), done_(beginnings, 0), kept_(beginnings) {}

  /// Calls `work(n)` for each n below `count`, lower ones first.
  void run(std::size_t count, const std::function<void(std::size_t)>& work) {
    const auto in_turn = [&](std::size_t, std::size_t n) { work(n); };
    caller_.wait_for([&] { parallel_in_turn(thread_count(), count, in_turn); },
                     [&] { return tell_news(); });
  }

  /// What a stop would keep of a beginning, with the root of the mean of squares in levels.
  struct Kept {
    TracedGrid grid;
    double error;
    bool is_grown;
  };

  /// Says how far the work on a beginning is, and what a stop would keep of it or of its rival.
  void say(std::size_t beginning, std::size_t done, Kept kept) {
    {
      const std::lock_guard lock(mutex_);
      done_[beginning] = done;
      kept_[beginning] = std::move(kept);
    }
    caller_.there_is_news();
  }
  /// Returns true if the work has to stop.
  bool is_over() const { return caller_.should_end(); }
  /// Returns what was told last, which is what is kept where the work had to stop.
  const std::optional<Kept>& told() const { return told_; }

 private:
  bool tell_news() {
    std::optional<Kept> best;
    std::size_t done = 0;
    {
      const std::lock_guard lock(mutex_);
      done = std::accumulate(done_.begin(), done_.end(), done);
      for (const std::optional<Kept>& kept : kept_)
        if (kept && (!best || is_to_be_shown(*kept, *best))) best = kept;
    }
    if (!best) return true;
    told_ = std::move(best);
    const LineGrid& grid = told_->grid.grid;
    if (tell_) tell_(grid);
    return !watch_.should_stop(
        {done, total_, grid.rows() * grid.columns(), told_->error / 255, grid.points()});
  }

  /// Returns true if the first rather than the second, which comes of an earlier beginning.
  static bool is_to_be_shown(const Kept& a, const Kept& b) {
    if (a.is_grown != b.is_grown) return a.is_grown;
    return a.is_grown && is_better(a.grid, b.grid);
  }

  StopWatch& watch_;
  const Tell& tell_;
  const std::size_t total_;
  std::optional<Kept> told_;
  WaitingCaller caller_;
  std::mutex mutex_;
  /// By beginning; guarded by the mutex.
  std::vector<std::size_t> done_;
  std::vector<std::optional<Kept>> kept_;
};

TracedGrid in_whole_levels(TracedGrid traced) {
  traced.grid = traced.grid.in_whole_levels();
  return traced;
}

/// At most how many lines and points a grid may have for a target: a patch has two pixels each way.
MostLines most_lines(const TargetPicture& target, int points) {
  return {std::max(1, target.height / 2), std::max(1, target.width / 2), points};
}

/// One beginning and what becomes of it: first it is grown, which is quick, then finished.
class Tracer {
 public:
  /// `number` is that of the beginning.
  Tracer(const Beginning& beginning, std::size_t number, const Pyramid& levels, int points,
         Telling& telling)
      : number_(number),
        counts_(beginning.counts),
        levels_(levels),
        is_enough_(beginning.is_enough),
        telling_(telling),
        most_(most_lines(*beginning.target, points)),
        grid_(beginning.grid),
        level_(std::min<std::size_t>(2, levels.size() - 1)) {}

  /// Puts lines in, on the smallest pictures that show what they gain.
  void grow_up() {
    fit_unasked({15, 1e-3});
    while (!is_growing_over() && !(is_to_ask() && find_enough()) && grow()) fit_unasked(shortly);
    find_enough();
    if (!telling_.is_over()) say(most_.points, result());
  }

  /// Fits on the whole picture, exchanges lines and takes out what is not needed. `rival` is the
  /// best of what other beginnings have grown to; null if there is none.
  void finish(const TracedGrid* rival) {
    kept_ = result();
    if (rival && is_better(*rival, *kept_)) kept_ = *rival;
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

  static constexpr FitLength shortly{3, 1e-3}, longer{10, 1e-3}, to_the_end{40, 5e-4},
      as_springs_want{60, 1e-4, 1e5};

  const TargetPicture& target() const { return levels_[level_]; }

  void fit(FitLength length) { squares_ = fit_lines(grid_, target(), evenness_, length); }

  /// Says how far the grid is, in points, and what a stop would keep that is grown.
  void say(int points, const TracedGrid& grown) {
    telling_.say(number_, std::size_t(points),
                 Telling::Kept{grown, rmse(grown.squares, levels_.front()), true});
  }

  /// Says how far the grid has grown. Returns true if the run has to stop.
  bool is_growing_over() {
    telling_.say(
        number_, std::size_t(grid_.points()),
        Telling::Kept{{grid_, number_, squares_, false, counts_}, rmse(squares_, target()), false});
    return telling_.is_over();
  }

  /// Says how far the grid is finished. How many steps that takes is not known: each goes an eighth
  /// of the way that is left. Returns true if the run has to stop.
  bool is_over() {
    finished_ += (most_.points - finished_) / 8;
    // A grid of which it was not asked counts as enough only if the one that is kept is: to ask
    // each time would make a run a tenth longer.
    const TracedGrid own{grid_.in_whole_levels(), number_, squares_on_whole(), kept_->is_enough,
                         counts_};
    if (is_better(own, *kept_) && (!own.is_enough || is_enough())) kept_ = own;
    say(most_.points + finished_, *kept_);
    return telling_.is_over();
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
    const std::optional<LineChange> line = best_new_line(grid_, target(), most, sliver_weight());
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

  double sliver_weight() const { return evenness_.for_patches(squares_ / grid_.patches()).slivers; }

  /// Fits for long, with less and less that holds the lines even.
  void settle() {
    constexpr int most_exchanges = 6;
    if (!is_over()) fit(to_the_end);
    for (int i = 0; i < most_exchanges && !is_over() && exchange(); ++i) {
    }
    const Evenness loosest = evenness_.loosest();
    for (int i = 0; i < Evenness::times_loosened && !is_over(); ++i) {
      evenness_ = evenness_.loosened();
      fit({6, 1e-3});
    }
    evenness_ = loosest;
    if (!is_over()) fit(as_springs_want);
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
    const std::optional<LineChange> line = cheapest_line(grid_, target(), sliver_weight());
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
  Telling& telling_;
  const MostLines most_;
  LineGrid grid_;
  std::size_t level_;
  /// What a stop would keep once the grid has grown: the best so far, of which a rival may be.
  std::optional<TracedGrid> kept_;
  /// How far finishing has come, in points.
  int finished_ = 0;
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
  Telling telling(beginnings.size(), (beginnings.size() + most_finished) * std::size_t(points),
                  watch, tell);
  std::map<const TargetPicture*, Pyramid> pyramids;
  std::vector<Tracer> tracers;
  for (std::size_t n = 0; n < beginnings.size(); ++n) {
    const TargetPicture* target = beginnings[n].target;
    if (!pyramids.contains(target)) pyramids[target] = pyramid(*target);
    tracers.emplace_back(beginnings[n], n, pyramids[target], points, telling);
  }
  telling.run(tracers.size(), [&](std::size_t n) {
    if (!telling.is_over()) tracers[n].grow_up();
  });
  std::vector<TracedGrid> found;
  for (Tracer& tracer : tracers) found.push_back(tracer.result());
  std::ranges::stable_sort(found, is_more_promising);
  const std::vector<TracedGrid> grown = found;
  telling.run(most_finished, [&](std::size_t n) {
    Tracer& tracer = tracers[grown[n].beginning];
    if (!telling.is_over()) tracer.finish(best_but(grown, n));
    found[n] = tracer.result();
  });
  return telling.is_over() ? in_whole_levels(telling.told()->grid) : *best_but(found, found.size());
}

}  // namespace gradmesh
