#include "methods/plain.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include "base/parallel.h"
#include "mesh/build.h"
#include "methods/lines.h"
#include "methods/portions.h"
#include "plain/corners.h"
#include "plain/flaws.h"
#include "plain/grid_fit.h"
#include "plain/harmful_sides.h"
#include "plain/line_rises.h"
#include "plain/side_rises.h"
#include "plain/steps.h"

namespace gradmesh {
namespace {

/// Steps of Gauss-Newton after a step of the selection, and where nothing more fits.
constexpr int fit_steps = 2, polish_steps = 4;

/// Returns the error that is about as large as the result's.
double usual_epsilon(const Bounds& bounds) { return bounds.target ? 0.01 : bounds.epsilon; }

/// A grid, and what is found of it as it will be written.
struct Outcome {
  PlainGrid grid;
  Candidate written;
  /// Of the sides that became straight those that harm details (plain/harmful_sides.h).
  std::vector<Side> harmful = {};

  /// `near` and `limit` as of Problem::measure.
  Outcome(PlainGrid made, const Problem& problem, const Outcome* near = nullptr,
          double limit = std::numeric_limits<double>::infinity())
      : grid(std::move(made)),
        written(problem.measure(build_derived_mesh(grid.parts()), near ? &near->written : nullptr,
                                limit)) {}
};

class Selection {
 public:
  /// `start` keeps to the bounds; `first_handles` is the number before anything was taken out.
  Selection(Outcome start, int first_handles, const Problem& problem, StopWatch& watch,
            const MeshPassed& passed)
      : now_(std::move(start)),
        problem_(problem),
        watch_(watch),
        passed_(passed),
        first_handles_(first_handles) {
    list_lines();
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
      for (Proposal& c : proposals_) c.priced_at = -1;
      too_much_.clear();
      do pass();
      while (made_ > made_when_too_much_ && !is_over_);
      if (!problem_.bounds.target || is_over_) break;
    }
    if (has_reached_target()) polish();
  }

  const Outcome& now() const { return now_; }
  int evaluations() const { return evaluations_; }

 private:
  /// A step, and what it led to from the grid of when `made_` was `priced_at`.
  struct Proposal {
    Step step;
    /// By how much the error rises for each handle saved, with a share for the largest error of a
    /// small part, and by how much the error rises in all.
    double price, rise = 0;
    int priced_at = -1;
    std::optional<Outcome> outcome = std::nullopt;
    /// True if the step was found to be too much in this pass.
    bool is_too_much = false;
  };

  /// A side, and `made_` when it cost too much to be straight.
  struct TooMuch {
    Side side;
    int made;
  };

  /// Lines that are priced at the same time: fixed, so that the result does not depend on the
  /// number of threads.
  static constexpr std::size_t at_once = 2;
  /// How many lines are priced to learn how the error rises with the squares, and the share of what
  /// that lets expect that a line hardly ever stays below.
  static constexpr std::size_t priced_first = 3;
  static constexpr double share_of_expected = 0.5;
  /// After so many single sides that were too much, one after the other, no more are tried in a
  /// pass: those that are left change the picture more.
  static constexpr int most_in_a_row = 40;
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
  double local_share(const Outcome& outcome) const {
    const auto share = [](double found, std::optional<double> bound) {
      return bound.value_or(0) > 0 ? found / *bound : 0;
    };
    return std::max(share(outcome.written.local_error, problem_.bounds.local),
                    share(outcome.written.detail_error, problem_.bounds.detail));
  }

  bool harms_details(const Outcome& outcome) const {
    const std::optional<double> bound = problem_.bounds.detail;
    return bound && outcome.written.detail_error > *bound;
  }

  void pass() {
    // What was too much for this very grid still is.
    for (Proposal& c : proposals_) c.is_too_much = c.is_too_much && c.priced_at == made_;
    std::erase_if(too_much_, [&](const TooMuch& side) { return side.made != made_; });
    too_much_in_a_row_ = 0;
    sides_proposed_at_ = -1;
    made_when_too_much_ = std::numeric_limits<int>::max();
    most_sides_ = std::numeric_limits<std::size_t>::max();
    while (!should_stop()) {
      propose_sides();
      std::ranges::stable_sort(proposals_, [](const Proposal& a, const Proposal& b) {
        return std::pair(a.is_too_much, a.price) < std::pair(b.is_too_much, b.price);
      });
      if (proposals_.empty() || proposals_.front().is_too_much) break;
      Proposal& best = proposals_.front();
      if (best.step.takes_line() && !lines_are_expected_)
        expect_lines();
      else if (best.priced_at != made_ && is_hopeless(best))
        give_up_first();
      else if (best.priced_at != made_)
        price_first();
      else if (best.outcome->written.keeps)
        accept_first();
      else if (!polish())
        give_up_first();
    }
  }

  void list_lines() {
    const double price = first_line_price * usual_epsilon(problem_.bounds) / first_handles_;
    for (const Along along : {Along::rows, Along::columns})
      for (int i = 1; i < (along == Along::rows ? grid().rows() : grid().columns()); ++i)
        if (grid().may_take_out(along, i)) proposals_.push_back({{{}, along, i}, price});
  }

  /// Prices the lines that are expected to be the cheapest, and gives the others the prices that
  /// these let expect: so each is priced when its turn comes, and most never.
  void expect_lines() {
    lines_are_expected_ = true;
    std::vector<Step> lines;
    std::vector<Proposal*> proposals;
    for (Proposal& c : proposals_) {
      if (!c.step.takes_line()) continue;
      lines.push_back(c.step);
      proposals.push_back(&c);
    }
    const std::vector<LineRise> rises = rises_without(grid(), lines, problem_.coarse_reference());
    std::vector<std::size_t> order(lines.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, {}, [&](std::size_t n) { return rises[n].by_handle(); });
    const auto first = order.begin(),
               last = first + std::ptrdiff_t(std::min(priced_first, lines.size()));
    std::vector<Proposal*> cheapest;
    std::for_each(first, last, [&](std::size_t n) { cheapest.push_back(proposals[n]); });
    price(cheapest);
    // The least found of how error and price rise with what is expected.
    double of_error = std::numeric_limits<double>::infinity(), of_price = of_error;
    std::for_each(first, last, [&](std::size_t n) {
      if (rises[n].root <= 0) return;
      of_error = std::min(of_error, std::max(0.0, proposals[n]->rise) / rises[n].root);
      of_price = std::min(of_price, proposals[n]->price / rises[n].by_handle());
    });
    if (!std::isfinite(of_error)) return;
    std::for_each(last, order.end(), [&](std::size_t n) {
      Proposal& c = *proposals[n];
      c.rise = share_of_expected * of_error * rises[n].root;
      c.price = std::max(c.price, share_of_expected * of_price * rises[n].by_handle());
    });
  }

  /// Sees to it that one proposal makes sides straight: of all that may still become so, the
  /// cheapest by the sums of squares before anything is fitted, and of these a part at a time.
  void propose_sides() {
    if (sides_proposed_at_ == made_) return;
    sides_proposed_at_ = made_;
    std::erase_if(proposals_, [](const Proposal& c) { return !c.step.takes_line(); });
    if (too_much_in_a_row_ >= most_in_a_row) return;
    std::vector<Side> sides = curved_sides(grid());
    std::erase_if(sides, [&](const Side& side) {
      return std::ranges::find(too_much_, side, &TooMuch::side) != too_much_.end() ||
             (!may_be_seen_ && makes_corner(grid(), side));
    });
    if (sides.empty()) return;
    const std::vector<double> rises = rises_if_straight(grid(), sides, problem_.coarse_reference());
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t n = 0; n < sides.size(); ++n) order.emplace_back(rises[n], n);
    std::ranges::sort(order);
    const std::size_t count =
        std::min({most_sides_, first_portion(sides.size()), sides_to_target()});
    Step step;
    for (std::size_t n = 0; n < count; ++n) step.sides.push_back(sides[order[n].second]);
    proposals_.push_back({std::move(step), -std::numeric_limits<double>::infinity()});
  }

  /// Measures a grid; an error above `limit` may be any that is.
  Outcome measured(PlainGrid grid, double limit) const {
    Outcome outcome(std::move(grid), problem_, &now_, limit);
    if (!may_be_seen_ && outcome.written.keeps && flaws_.are_worse(outcome.grid))
      outcome.written.keeps = false;
    return outcome;
  }

  /// Returns what a step leads to, with the points near it fitted anew. Where a line is gone the
  /// colours beside it have more to show. A grid that breaks the local bound alone is fitted once
  /// more, which lowers the peaks.
  Outcome after(const Step& step) const {
    PlainGrid grid = now_.grid;
    make(step, grid);
    const GridPoints points = points_near(step, grid);
    if (step.takes_line())
      fit_grid_and_colors(grid, picture(), fit_steps, points);
    else
      fit_grid(grid, picture(), fit_steps, points);
    Outcome first = measured(grid, hopeless_error());
    if (harms_details(first))
      first.harmful = harmful_sides(step.sides, first.grid, first.written.measured->details(),
                                    *problem_.bounds.detail, picture().frame());
    if (first.written.keeps || first.written.error > epsilon() || local_share(first) > may_fall)
      return first;
    if (!step.takes_line() && harms_details(first)) {
      // A fit hardly brings an edge back that a curve held in its place. For the sake of the mean
      // it may harm a detail elsewhere that was at its bound before.
      if (!first.harmful.empty()) return first;
      PlainGrid unfitted = now_.grid;
      make(step, unfitted);
      Outcome bare = measured(std::move(unfitted), epsilon());
      return bare.written.keeps ? bare : first;
    }
    fit_grid_and_colors(grid, picture(), fit_steps, points);
    Outcome second = measured(std::move(grid), epsilon());
    return second.written.keeps ? second : first;
  }

  /// Prices the first proposal, and with a line the next one that has no price of this grid.
  void price_first() {
    std::vector<Proposal*> stale;
    for (Proposal& c : proposals_)
      if (stale.size() < at_once && c.priced_at != made_ && !c.is_too_much && !is_hopeless(c) &&
          c.step.takes_line() == proposals_.front().step.takes_line())
        stale.push_back(&c);
    price(stale);
  }

  void price(const std::vector<Proposal*>& proposals) {
    evaluations_ += int(proposals.size());
    parallel_for(proposals.size(), [&](std::size_t n) {
      Proposal& c = *proposals[n];
      c.outcome = after(c.step);
      c.rise = c.outcome->written.error - now_.written.error;
      const double local_rise = std::max(0.0, local_share(*c.outcome) - local_);
      c.price = (c.rise + local_weight * usual_epsilon(problem_.bounds) * local_rise) /
                (grid().handles() - c.outcome->grid.handles());
      c.priced_at = made_;
    });
    keep_one_picture();
  }

  /// Keeps the picture of the cheapest priced proposal, which is likely to be the next: pictures
  /// are large.
  void keep_one_picture() {
    Proposal* cheapest = nullptr;
    for (Proposal& c : proposals_) {
      if (!c.outcome) continue;
      Proposal* dearer = &c;
      if (!cheapest || c.price < cheapest->price) std::swap(cheapest, dearer);
      if (dearer) dearer->outcome->written.measured.reset();
    }
  }

  bool is_hopeless(const Proposal& proposal) const {
    return now_.written.error + least_share_of_rise * proposal.rise > epsilon();
  }
  /// Returns the error of a step above which it is hopeless.
  double hopeless_error() const {
    return now_.written.error + (epsilon() - now_.written.error) / least_share_of_rise;
  }

  void accept_first() {
    Proposal first = std::move(proposals_.front());
    proposals_.erase(proposals_.begin());
    take(*first.outcome);
    too_much_in_a_row_ = 0;
    if (first.step.takes_line())
      renumber_without(first.step);
    else
      most_sides_ = std::max(most_sides_, 2 * first.step.sides.size());
  }

  void take(Outcome& outcome) {
    if (!outcome.written.measured) outcome = Outcome(std::move(outcome.grid), problem_, &now_);
    now_ = std::move(outcome);
    local_ = local_share(now_);
    ++made_;
    // What was found of the other proposals is of the grid before.
    for (Proposal& c : proposals_) c.outcome.reset();
    tell();
  }

  void tell() const {
    if (passed_) passed_(now_.written);
  }

  void renumber_without(const Step& gone) {
    for (Proposal& c : proposals_)
      if (c.step.along == gone.along && c.step.line > gone.line) --c.step.line;
    std::erase_if(too_much_, [&](TooMuch& too_much) {
      int& at = gone.along == Along::rows ? too_much.side.row : too_much.side.column;
      if (at > gone.line) --at;
      // The sides beside the line are others now.
      return at == gone.line || at == gone.line - 1;
    });
  }

  /// Fits the whole grid once more before a step that is too much for it is given up. Returns true
  /// if that lowers the error, so that the step may fit.
  bool polish() {
    if (polished_at_ >= 0 && made_ < polished_at_ + steps_between_polishes) return false;
    PlainGrid grid = now_.grid;
    fit_grid_and_colors(grid, picture(), polish_steps, GridPoints::all(grid));
    Outcome outcome = measured(std::move(grid), now_.written.error);
    ++evaluations_;
    constexpr double worth_it = 0.99;
    const bool helps =
        outcome.written.keeps && outcome.written.error < worth_it * now_.written.error;
    if (helps) take(outcome);
    polished_at_ = made_;
    return helps;
  }

  /// Gives up the first proposal in this pass; of several sides fewer are tried.
  void give_up_first() {
    made_when_too_much_ = std::min(made_when_too_much_, made_);
    Proposal& first = proposals_.front();
    first.is_too_much = true;
    const std::optional<Outcome> outcome = std::exchange(first.outcome, std::nullopt);
    if (first.step.takes_line()) return;
    sides_proposed_at_ = -1;
    if (first.step.sides.size() > 1 && outcome && !outcome->harmful.empty()) {
      for (const Side& side : outcome->harmful) too_much_.push_back({side, made_});
    } else if (first.step.sides.size() > 1) {
      most_sides_ = smaller_portion(first.step.sides.size());
    } else {
      too_much_.push_back({first.step.sides.front(), made_});
      ++too_much_in_a_row_;
    }
  }

  bool has_reached_target() const {
    return problem_.bounds.target && problem_.bounds.target->is_reached(grid().counts());
  }

  /// Returns how many sides must become straight to reach a number of handles.
  std::size_t sides_to_target() const {
    if (!problem_.bounds.target || problem_.bounds.target->what != Count::handles)
      return std::numeric_limits<std::size_t>::max();
    const int too_many = grid().handles() - problem_.bounds.target->most;
    return std::size_t(std::max(1, (too_many + 1) / 2));
  }

  bool should_stop() {
    const int handles = grid().handles();
    is_over_ =
        has_reached_target() ||
        watch_.should_stop({std::size_t(first_handles_ - handles), std::size_t(first_handles_),
                            grid().rows() * grid().columns(), now_.written.error, handles});
    return is_over_;
  }

  Outcome now_;
  /// As of local_share().
  double local_ = 0;
  bool may_be_seen_ = false;
  Problem problem_;
  const Flaws flaws_{grid(), picture()};
  StopWatch& watch_;
  const MeshPassed& passed_;
  const int first_handles_;
  std::vector<Proposal> proposals_;
  /// Sides that cost too much to be straight, in this pass or for this very grid.
  std::vector<TooMuch> too_much_;
  /// The most sides that are made straight at once, in this pass.
  std::size_t most_sides_ = 0;
  /// The number of steps that were made and of fits of the whole, and how many these were when
  /// sides were proposed and when the whole was last fitted.
  int made_ = 0, sides_proposed_at_ = -1, polished_at_ = -1;
  /// The number that had been made when the first step of this pass was found to be too much.
  int made_when_too_much_ = 0;
  int too_much_in_a_row_ = 0;
  int evaluations_ = 0;
  bool is_over_ = false, lines_are_expected_ = false;
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
  return without_lines(free, quick);
}

/// Returns the grid with which a selection begins; nothing if it cannot be fitted so that it keeps
/// to the bounds.
std::optional<Outcome> start_of(const Problem& problem, int handles, StopWatch& watch) {
  const Candidate fewer = without_free_lines(problem, handles, watch);
  // Sides that are hardly bent are straight as they are written.
  PlainGrid grid(fewer.surface());
  grid.fix_as(PlainGrid(fewer.mesh));
  Outcome start(grid, problem);
  if (start.written.keeps) return start;
  // The twists that are lost.
  constexpr int steps = 8;
  PlainGrid fitted = grid;
  fit_grid(fitted, *problem.reference(), steps);
  start = Outcome(std::move(fitted), problem);
  if (!start.written.keeps) return std::nullopt;
  return start;
}

}  // namespace

Candidate make_plain(const Problem& problem, StopWatch& watch) {
  // Paints what is shared before several threads measure.
  Candidate unchanged = problem.unchanged();
  const int first_handles = PlainGrid(problem.mesh()).handles();
  std::optional<Outcome> start = start_of(problem, first_handles, watch);
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
