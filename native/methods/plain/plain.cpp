#include "methods/plain/plain.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/parallel.h"
#include "methods/merging/lines.h"
#include "methods/plain/flaws.h"
#include "methods/plain/grid_fit.h"
#include "methods/plain/plain_queue.h"
#include "methods/plain/steps.h"

namespace gradmesh {
namespace {

/// Steps of Gauss-Newton after a step of the selection, and where nothing more fits.
constexpr int fit_steps = 2, polish_steps = 4;

/// Returns the error that is about as large as the result's.
double usual_epsilon(const Bounds& bounds) { return bounds.target ? 0.01 : bounds.epsilon; }

class Selection {
 public:
  /// `start` keeps to the bounds; `first_handles` is the number before anything was taken out.
  Selection(PlainCandidate start, int first_handles, const Problem& problem, StopWatch& watch,
            const MeshPassed& passed)
      : now_(std::move(start)),
        problem_(problem),
        watch_(watch),
        passed_(passed),
        first_handles_(first_handles),
        queue_(grid(), first_line_price * usual_epsilon(problem_.bounds) / first_handles_) {
    tell();
  }

  /// Lets what is next keep to wider bounds.
  void widen(const Bounds& bounds) { problem_ = problem_.within(bounds); }

  /// Passes go on as long as steps are made after others were found to be too much, which may keep
  /// to epsilon now that the points have been fitted anew. A target that cannot be reached without
  /// flaws that are seen is reached with them.
  void run() {
    for (const bool may_be_seen : {false, true}) {
      may_be_seen_ = may_be_seen;
      queue_.forget_prices();
      do pass();
      while (queue_.has_made_room() && !is_over_);
      if (!problem_.bounds.target || is_over_) break;
    }
    if (has_reached_target()) polish();
  }

  const PlainCandidate& now() const { return now_; }
  int evaluations() const { return evaluations_; }

 private:
  /// Lines are first looked at when sides cost more than this times epsilon over all handles.
  static constexpr double first_line_price = 3;
  /// How much it counts if the largest error of a small part comes nearer to its bound: a step that
  /// exhausts the bound in one place keeps others from being made, since most change that place a
  /// little.
  static constexpr double local_weight = 0.3;
  /// Peaks above this share of the local bound do not fall below it by another fit.
  static constexpr double may_fall = 1.5;
  /// Fits of the whole grid lower its error where much has changed since the last.
  static constexpr int steps_between_polishes = 5;
  /// The error that a step adds falls as others are made and the grid is fitted anew, but hardly
  /// below this share.
  static constexpr double least_share_of_rise = 0.5;

  const PlainGrid& grid() const { return now_.grid; }
  const Reference& picture() const { return *problem_.reference(); }
  double epsilon() const { return problem_.bounds.epsilon; }

  /// Returns the largest error of a small part or of a detail as a share of its bound, whichever is
  /// larger; 0 if there is none.
  double local_share(const PlainCandidate& outcome) const {
    const auto share = [](double found, std::optional<double> bound) {
      return bound.value_or(0) > 0 ? found / *bound : 0;
    };
    return std::max(share(outcome.written.local_error, problem_.bounds.local),
                    share(outcome.written.detail_error, problem_.bounds.detail));
  }

  bool harms_details(const PlainCandidate& outcome) const {
    const std::optional<double> bound = problem_.bounds.detail;
    return bound && outcome.written.detail_error > *bound;
  }

  void pass() {
    queue_.begin_pass();
    while (!should_stop()) {
      queue_.propose_sides(grid(), problem_, may_be_seen_);
      const ProposedStep* const first = queue_.first();
      if (!first) break;
      if (first->step.takes_line() && !queue_.are_lines_expected())
        queue_.expect_lines(grid(), problem_, [&](const auto& lines) { price(lines); });
      else if (!queue_.is_priced(*first) && is_hopeless(*first))
        queue_.give_up_first();
      else if (!queue_.is_priced(*first))
        price(queue_.next_unpriced([&](const ProposedStep& c) { return !is_hopeless(c); }));
      else if (first->outcome->written.keeps)
        accept_first();
      else if (!polish())
        queue_.give_up_first();
    }
  }

  /// Measures a grid that differs little from that of `near`; an error above `limit` may be any
  /// that is.
  PlainCandidate measured(PlainGrid grid, double limit, const PlainCandidate& near) const {
    PlainCandidate outcome(std::move(grid), problem_, &near, limit);
    if (!may_be_seen_ && outcome.written.keeps && flaws_.are_worse(outcome.grid))
      outcome.written.keeps = false;
    return outcome;
  }

  PlainCandidate measured(PlainGrid grid, double limit) const {
    return measured(std::move(grid), limit, now_);
  }

  /// Puts points, and the sides that begin there, back to where they are now, but for some sides
  /// that stay straight.
  void put_back(const GridPoints& points, const std::vector<Side>& straight,
                PlainGrid& changed) const {
    points.for_each([&](int row, int column) {
      changed.knot(row, column) = grid().knot(row, column);
      for (const Along along : {Along::rows, Along::columns})
        changed.bend(along, row, column) = grid().bend(along, row, column);
    });
    for (const Side& side : straight) changed.bend(side.along, side.row, side.column).reset();
  }

  /// Lets those of the sides that a step made straight be curves again that harm details, one after
  /// the other until none does, with the points near them fitted anew. Most of a portion does no
  /// harm, and to fit and measure the rest from the start again takes many times as long.
  PlainCandidate without_harm(PlainCandidate found, std::vector<Side> straight) const {
    std::vector<Side> harmful;
    while (harms_details(found)) {
      const std::vector<Side> more =
          harmful_sides(straight, found.grid, found.written.measured->details(),
                        *problem_.bounds.detail, picture().frame());
      if (more.empty()) break;
      harmful.insert(harmful.end(), more.begin(), more.end());
      std::erase_if(straight,
                    [&](const Side& side) { return std::ranges::find(more, side) != more.end(); });
      if (straight.empty()) break;
      PlainGrid grid = found.grid;
      const GridPoints near = points_near({more}, grid);
      put_back(near, straight, grid);
      fit_grid(grid, picture(), fit_steps, near);
      found = measured(std::move(grid), hopeless_error(), found);
    }
    found.harmful = std::move(harmful);
    return found;
  }

  /// Returns what a step leads to, with the points near it fitted anew; where many sides become
  /// straight all points, which mends on the way what earlier steps left. Where a line is gone the
  /// colours beside it have more to show. A grid that breaks the local bound alone is fitted once
  /// more, which lowers the peaks.
  PlainCandidate after(const Step& step) const {
    PlainGrid grid = now_.grid;
    make(step, grid);
    constexpr std::size_t few_sides = 4;
    const GridPoints points =
        step.sides.size() > few_sides ? GridPoints::all(grid) : points_near(step, grid);
    if (step.takes_line())
      fit_grid_and_colors(grid, picture(), fit_steps, points);
    else
      fit_grid(grid, picture(), fit_steps, points);
    PlainCandidate first = without_harm(measured(grid, hopeless_error()), step.sides);
    if (first.written.keeps || first.written.error > epsilon() || local_share(first) > may_fall)
      return first;
    if (!step.takes_line() && harms_details(first)) {
      // A fit hardly brings an edge back that a curve held in its place. For the sake of the mean
      // it may harm a detail elsewhere that was at its bound before.
      if (!first.harmful.empty()) return first;
      PlainGrid unfitted = now_.grid;
      make(step, unfitted);
      PlainCandidate bare = measured(std::move(unfitted), epsilon());
      return bare.written.keeps ? bare : first;
    }
    grid = first.grid;
    fit_grid_and_colors(grid, picture(), fit_steps, points);
    PlainCandidate second = measured(std::move(grid), epsilon());
    second.harmful = first.harmful;
    return second.written.keeps ? second : first;
  }

  void price(const std::vector<ProposedStep*>& proposals) {
    evaluations_ += int(proposals.size());
    parallel_for(proposals.size(), [&](std::size_t n) {
      ProposedStep& c = *proposals[n];
      c.outcome = after(c.step);
      c.rise = c.outcome->written.error - now_.written.error;
      const double local_rise = std::max(0.0, local_share(*c.outcome) - local_);
      c.price = (c.rise + local_weight * usual_epsilon(problem_.bounds) * local_rise) /
                (grid().handles() - c.outcome->grid.handles());
      c.priced_at = queue_.made();
    });
    queue_.keep_one_picture();
  }

  bool is_hopeless(const ProposedStep& proposal) const {
    return now_.written.error + least_share_of_rise * proposal.rise > epsilon();
  }
  /// Returns the error of a step above which it is hopeless.
  double hopeless_error() const {
    return now_.written.error + (epsilon() - now_.written.error) / least_share_of_rise;
  }

  void accept_first() {
    ProposedStep first = queue_.take_first();
    take(*first.outcome);
  }

  void take(PlainCandidate& outcome) {
    if (!outcome.written.measured)
      outcome = PlainCandidate(std::move(outcome.grid), problem_, &now_);
    now_ = std::move(outcome);
    local_ = local_share(now_);
    queue_.begin_grid();
    tell();
  }

  void tell() const {
    if (passed_) passed_(now_.written);
  }

  /// Fits the whole grid once more before a step that is too much for it is given up. Returns true
  /// if that lowers the error, so that the step may fit.
  bool polish() {
    if (polished_at_ >= 0 && queue_.made() < polished_at_ + steps_between_polishes) return false;
    PlainGrid grid = now_.grid;
    fit_grid_and_colors(grid, picture(), polish_steps, GridPoints::all(grid));
    PlainCandidate outcome = measured(std::move(grid), now_.written.error);
    ++evaluations_;
    constexpr double worth_it = 0.99;
    const bool helps =
        outcome.written.keeps && outcome.written.error < worth_it * now_.written.error;
    if (helps) take(outcome);
    polished_at_ = queue_.made();
    return helps;
  }

  bool has_reached_target() const {
    return problem_.bounds.target && problem_.bounds.target->is_reached(grid().counts());
  }

  bool should_stop() {
    const int handles = grid().handles();
    is_over_ =
        has_reached_target() ||
        watch_.should_stop({std::size_t(first_handles_ - handles), std::size_t(first_handles_),
                            grid().rows() * grid().columns(), now_.written.error, handles});
    return is_over_;
  }

  PlainCandidate now_;
  /// As of local_share().
  double local_ = 0;
  bool may_be_seen_ = false;
  Problem problem_;
  const Flaws flaws_{grid(), picture()};
  StopWatch& watch_;
  const MeshPassed& passed_;
  const int first_handles_;
  PlainQueue queue_;
  /// PlainQueue::made() when the whole was last fitted.
  int polished_at_ = -1;
  int evaluations_ = 0;
  bool is_over_ = false;
};

/// Returns the mesh without the lines that cost next to nothing, such as those that a program put
/// in exactly: they need no fit to go.
Candidate without_free_lines(const Problem& problem, int handles, StopWatch& watch) {
  constexpr double share = 0.1, share_of_detail = 0.5;
  Problem free = problem;
  free.bounds.epsilon = share * usual_epsilon(problem.bounds);
  if (free.bounds.detail) *free.bounds.detail *= share_of_detail;
  // A person is told of handles throughout.
  StopWatch quick(0, [&](const Progress& of_lines) {
    return !watch.should_stop({0, std::size_t(handles), of_lines.patches, of_lines.error, handles});
  });
  return take_out_lines(free, quick);
}

/// Returns the grid with which a selection begins; nothing if it cannot be fitted so that it keeps
/// to the bounds.
std::optional<PlainCandidate> start_of(const Problem& problem, int handles, StopWatch& watch) {
  const Candidate fewer = without_free_lines(problem, handles, watch);
  // Sides that are hardly bent are straight as they are written.
  PlainGrid grid(fewer.surface());
  grid.fix_as(PlainGrid(fewer.mesh));
  PlainCandidate start(grid, problem);
  if (start.written.keeps) return start;
  // The twists that are lost.
  constexpr int steps = 8;
  PlainGrid fitted = grid;
  fit_grid(fitted, *problem.reference(), steps);
  start = PlainCandidate(std::move(fitted), problem);
  if (!start.written.keeps) return std::nullopt;
  return start;
}

}  // namespace

Candidate make_plain(const Problem& problem, StopWatch& watch) {
  // Paints what is shared before several threads measure.
  Candidate unchanged = problem.unchanged();
  const int first_handles = PlainGrid(problem.mesh()).handles();
  std::optional<PlainCandidate> start = start_of(problem, first_handles, watch);
  if (!start) return unchanged;
  const MeshPassed nobody;
  Selection selection(*std::move(start), first_handles, problem, watch, nobody);
  selection.run();
  if (selection.now().grid.handles() >= first_handles) return unchanged;
  problem.count_evaluations(selection.evaluations());
  Candidate simpler = selection.now().written;
  simpler.error_added_up = simpler.error;
  return simpler;
}

void pass_plain(const Problem& problem, const std::vector<Bounds>& bounds, StopWatch& watch,
                const MeshPassed& passed, const std::function<void(std::size_t)>& is_through) {
  problem.unchanged();
  const int first_handles = PlainGrid(problem.mesh()).handles();
  std::optional<Selection> selection;
  for (std::size_t n = 0; n < bounds.size() && !watch.is_over(); ++n) {
    const Problem within = problem.within(bounds[n]);
    if (selection) {
      selection->widen(bounds[n]);
    } else if (auto start = start_of(within, first_handles, watch)) {
      selection.emplace(*std::move(start), first_handles, within, watch, passed);
    } else {
      continue;
    }
    selection->run();
    if (!watch.is_over()) is_through(n);
  }
}

}  // namespace gradmesh
