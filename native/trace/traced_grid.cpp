#include "trace/traced_grid.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "base/clamped_int.h"
#include "trace/equations.h"
#include "trace/line_changes.h"
#include "trace/line_fit.h"

namespace gradmesh {
namespace {

/// The target and smaller ones, each half as large as the one before.
std::vector<TargetPicture> pyramid(const TargetPicture& target) {
  constexpr int smallest = 16, most = 4;
  std::vector<TargetPicture> levels{target};
  while (levels.size() < most &&
         std::min(levels.back().width, levels.back().height) >= 2 * smallest)
    levels.push_back(halved(levels.back()));
  return levels;
}

/// Returns the root of the mean of squares, in levels.
double rmse(double squares, const TargetPicture& target) {
  return std::sqrt(squares / (channels(target) * double(target.samples())));
}

/// Returns the grid with colours as documents have them.
LineGrid in_whole_levels(LineGrid grid) {
  for (int n = 0; n < grid.points(); ++n) grid.knot(n).color = glm::round(grid.knot(n).color);
  return grid;
}

/// Where the lines end up depends on where the first ones were: more than one beginning is tried.
struct Attempt {
  /// About how many patches the first grid has each way.
  double across;
  std::size_t number, count;
};

/// What became of an attempt.
struct Traced {
  LineGrid grid;
  double squares;
  bool is_enough;

  bool is_better_than(const Traced& other) const {
    if (is_enough != other.is_enough) return is_enough;
    if (is_enough && grid.points() != other.grid.points())
      return grid.points() < other.grid.points();
    return squares < other.squares;
  }
};

class Tracer {
 public:
  Tracer(const std::vector<TargetPicture>& levels, glm::dvec2 size, const GridOptions& options,
         StopWatch& watch, const Attempt& attempt)
      : levels_(levels),
        options_(options),
        watch_(watch),
        attempt_(attempt),
        most_{std::max(1, levels.front().height / 2), std::max(1, levels.front().width / 2),
              options.points},
        grid_(beginning(size)) {}

  Traced run() {
    level_ = std::min<std::size_t>(2, levels_.size() - 1);
    fit({15, 1e-3});
    while (!is_over() && !is_enough() && grow()) fit(shortly);
    while (level_ > 0 && !watch_.is_over()) {
      --level_;
      fit({8, 1e-3});
    }
    settle();
    while (options_.is_enough && !is_over() && !is_enough() && grow()) fit(longer);
    while (!watch_.is_over() && take_out()) {
    }
    return {in_whole_levels(grid_), squares_, is_enough()};
  }

 private:
  static constexpr FitLength shortly{3, 1e-3}, longer{10, 1e-3}, to_the_end{40, 5e-4};

  const TargetPicture& target() const { return levels_[level_]; }

  /// Returns an even grid of few, about square patches.
  LineGrid beginning(glm::dvec2 size) const {
    const double shape = std::sqrt(size.x / size.y);
    int columns = clamped_int(attempt_.across * shape + 0.5, 1, std::min(16, most_.columns));
    int rows = clamped_int(attempt_.across / shape + 0.5, 1, std::min(16, most_.rows));
    while ((rows + 1) * (columns + 1) > most_.points) rows >= columns ? --rows : --columns;
    return LineGrid(rows, columns, size);
  }

  void fit(FitLength length) { squares_ = fit_lines(grid_, target(), evenness_, length); }

  bool is_over() {
    const auto points = std::size_t(options_.points);
    return watch_.should_stop({attempt_.number * points + std::size_t(grid_.points()),
                               attempt_.count * points, grid_.rows() * grid_.columns(),
                               rmse(squares_, target()) / 255, grid_.points()});
  }

  bool is_enough() {
    constexpr double hardly_seen = 0.3;
    if (!options_.is_enough) return rmse(squares_, target()) < hardly_seen;
    // The grid is painted for the answer, which is asked for more than once.
    if (!judged_ || judged_->first != grid_)
      judged_ = std::pair(grid_, options_.is_enough(in_whole_levels(grid_)));
    return judged_->second;
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
    if (!watch_.is_over()) fit(to_the_end);
    for (int i = 0; i < most_exchanges && !watch_.is_over() && exchange(); ++i) {
    }
    for (int i = 0; i < times && !watch_.is_over(); ++i) {
      evenness_ = evenness_.times(0.25);
      fit({6, 1e-3});
    }
    if (!watch_.is_over()) fit(to_the_end);
  }

  /// Takes the cheapest line out and puts lines in where they help more now. Returns false if that
  /// was no better, and nothing has changed.
  bool exchange() {
    constexpr double little = 1e-3;
    const LineGrid before = grid_;
    const double squares = squares_;
    MostLines most = most_;
    if (is_enough()) most.points = before.points();
    if (!without_cheapest()) return false;
    fit(shortly);
    while (grow(most)) fit(shortly);
    fit(longer);
    return squares_ < (1 - little) * squares || restore(before, squares);
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

  const std::vector<TargetPicture>& levels_;
  const GridOptions& options_;
  StopWatch& watch_;
  const Attempt attempt_;
  const MostLines most_;
  LineGrid grid_;
  std::size_t level_ = 0;
  Evenness evenness_;
  double squares_ = 0;
  /// The last grid of which it was asked whether it is enough, and the answer.
  std::optional<std::pair<LineGrid, bool>> judged_;
};

}  // namespace

LineGrid traced_grid(const TargetPicture& target, glm::dvec2 size, const GridOptions& options,
                     StopWatch& watch) {
  const std::vector<TargetPicture> levels = pyramid(target);
  constexpr double beginnings[] = {6, 5};
  std::optional<Traced> best;
  for (std::size_t n = 0; n < std::size(beginnings) && !(best && watch.is_over()); ++n) {
    Traced found =
        Tracer(levels, size, options, watch, {beginnings[n], n, std::size(beginnings)}).run();
    if (!best || found.is_better_than(*best)) best = std::move(found);
  }
  return std::move(best->grid);
}

}  // namespace gradmesh
