#include "trace/traced_grid.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <vector>

#include "base/clamped_int.h"
#include "trace/line_fit.h"
#include "trace/new_line.h"

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
  return std::sqrt(squares / (3.0 * double(target.samples())));
}

/// Returns the grid with colours as documents have them.
LineGrid in_whole_levels(LineGrid grid) {
  for (int n = 0; n < grid.points(); ++n) grid.knot(n).color = glm::round(grid.knot(n).color);
  return grid;
}

class Tracer {
 public:
  Tracer(const TargetPicture& target, glm::dvec2 size, const GridOptions& options, StopWatch& watch)
      : levels_(pyramid(target)),
        options_(options),
        watch_(watch),
        most_{std::max(1, target.height / 2), std::max(1, target.width / 2), options.points},
        grid_(beginning(size)) {}

  LineGrid run() {
    level_ = std::min<std::size_t>(2, levels_.size() - 1);
    fit({15, 1e-3});
    while (grow()) {
    }
    while (level_ > 0 && !watch_.is_over()) {
      --level_;
      fit({8, 1e-3});
    }
    settle();
    while (options_.is_enough && add_line()) fit({10, 1e-3});
    return in_whole_levels(grid_);
  }

 private:
  const TargetPicture& target() const { return levels_[level_]; }

  /// Returns an even grid of few, about square patches.
  LineGrid beginning(glm::dvec2 size) const {
    constexpr double across = 4;
    const int points = most_.points;
    const double shape = std::sqrt(size.x / size.y);
    int columns = clamped_int(across * shape + 0.5, 1, std::min(16, most_.columns));
    int rows = clamped_int(across / shape + 0.5, 1, std::min(16, most_.rows));
    while ((rows + 1) * (columns + 1) > points && rows + columns > 2)
      rows >= columns ? --rows : --columns;
    return LineGrid(rows, columns, size);
  }

  void fit(FitLength length) { squares_ = fit_lines(grid_, target(), evenness_, length); }

  /// Puts one line in, and fits as long as that pays while more lines come. Returns false as
  /// add_line() does.
  bool grow() {
    refine_level();
    if (!add_line()) return false;
    fit({3, 1e-3});
    return true;
  }

  /// Puts one line in. Returns false if there is none to put in, or no more are wanted.
  bool add_line() {
    constexpr double hardly_seen = 0.3;
    const Progress progress{std::size_t(grid_.points()), std::size_t(options_.points),
                            grid_.rows() * grid_.columns(), rmse(squares_, target()) / 255,
                            grid_.points()};
    if (watch_.should_stop(progress) || rmse(squares_, target()) < hardly_seen) return false;
    if (options_.is_enough && options_.is_enough(in_whole_levels(grid_))) return false;
    const std::optional<NewLine> line = best_new_line(grid_, target(), most_);
    if (!line || !(line->gain > 0)) return false;
    grid_ = grid_.with_line(line->along, line->strip);
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
    constexpr int times = 4;
    constexpr FitLength to_the_end{40, 5e-4}, some{6, 1e-3};
    if (!watch_.is_over()) fit(to_the_end);
    for (int i = 0; i < times && !watch_.is_over(); ++i) {
      evenness_ = evenness_.times(0.25);
      fit(some);
    }
    if (!watch_.is_over()) fit(to_the_end);
  }

  const std::vector<TargetPicture> levels_;
  const GridOptions& options_;
  StopWatch& watch_;
  const MostLines most_;
  LineGrid grid_;
  std::size_t level_ = 0;
  Evenness evenness_;
  double squares_ = 0;
};

}  // namespace

LineGrid traced_grid(const TargetPicture& target, glm::dvec2 size, const GridOptions& options,
                     StopWatch& watch) {
  return Tracer(target, size, options, watch).run();
}

}  // namespace gradmesh
