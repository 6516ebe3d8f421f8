#include "methods/plain/plain_queue.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "mesh/build.h"
#include "methods/merging/portions.h"
#include "methods/plain/flaws.h"
#include "methods/plain/rises.h"

namespace gradmesh {
namespace {

/// Lines that are priced at the same time: fixed, so that the result does not depend on the number
/// of threads.
constexpr std::size_t at_once = 2;
/// How many lines are priced to learn how the error rises with the squares, and the share of what
/// that lets expect that a line hardly ever stays below.
constexpr std::size_t priced_first = 3;
constexpr double share_of_expected = 0.5;
/// After so many single sides that were too much, one after the other, no more are tried in a pass:
/// those that are left change the picture more.
constexpr int most_in_a_row = 40;

/// Returns how many sides must become straight to reach a number of handles.
std::size_t sides_to_target(const PlainGrid& grid, const Bounds& bounds) {
  if (!bounds.target || bounds.target->what != Count::handles)
    return std::numeric_limits<std::size_t>::max();
  const int too_many = grid.handles() - bounds.target->most;
  return std::size_t(std::max(1, (too_many + 1) / 2));
}

}  // namespace

PlainCandidate::PlainCandidate(PlainGrid made, const Problem& problem, const PlainCandidate* near,
                               double limit)
    : grid(std::move(made)),
      written(problem.measure(build_derived_mesh(grid.parts()), near ? &near->written : nullptr,
                              limit)) {}

PlainQueue::PlainQueue(const PlainGrid& grid, double line_price) {
  for (const Along along : {Along::rows, Along::columns})
    for (int i = 1; i < (along == Along::rows ? grid.rows() : grid.columns()); ++i)
      if (grid.may_take_out(along, i)) proposals_.push_back({{{}, along, i}, line_price});
}

void PlainQueue::begin_grid() {
  ++made_;
  for (ProposedStep& c : proposals_) c.outcome.reset();
}

void PlainQueue::forget_prices() {
  for (ProposedStep& c : proposals_) c.priced_at = -1;
  too_much_.clear();
}

void PlainQueue::begin_pass() {
  // What was too much for this very grid still is.
  for (ProposedStep& c : proposals_) c.is_too_much = c.is_too_much && is_priced(c);
  std::erase_if(too_much_, [&](const TooMuch& side) { return side.made != made_; });
  too_much_in_a_row_ = 0;
  sides_proposed_at_ = -1;
  made_when_too_much_ = std::numeric_limits<int>::max();
  most_sides_ = std::numeric_limits<std::size_t>::max();
}

void PlainQueue::propose_sides(const PlainGrid& grid, const Problem& problem, bool may_be_seen) {
  if (sides_proposed_at_ == made_) return;
  sides_proposed_at_ = made_;
  std::erase_if(proposals_, [](const ProposedStep& c) { return !c.step.takes_line(); });
  if (too_much_in_a_row_ >= most_in_a_row) return;
  std::vector<Side> sides = curved_sides(grid);
  std::erase_if(sides, [&](const Side& side) {
    return std::ranges::find(too_much_, side, &TooMuch::side) != too_much_.end() ||
           (!may_be_seen && makes_corner(grid, side));
  });
  if (sides.empty()) return;
  const std::vector<double> rises = rises_if_straight(grid, sides, problem.coarse_reference());
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t n = 0; n < sides.size(); ++n) order.emplace_back(rises[n], n);
  std::ranges::sort(order);
  const std::size_t count =
      std::min({most_sides_, first_portion(sides.size()), sides_to_target(grid, problem.bounds)});
  Step step;
  for (std::size_t n = 0; n < count; ++n) step.sides.push_back(sides[order[n].second]);
  proposals_.push_back({std::move(step), -std::numeric_limits<double>::infinity()});
}

void PlainQueue::expect_lines(const PlainGrid& grid, const Problem& problem, const Pricing& price) {
  are_lines_expected_ = true;
  std::vector<Step> lines;
  std::vector<ProposedStep*> proposals;
  for (ProposedStep& c : proposals_) {
    if (!c.step.takes_line()) continue;
    lines.push_back(c.step);
    proposals.push_back(&c);
  }
  const std::vector<LineRise> rises = rises_without(grid, lines, problem.coarse_reference());
  std::vector<std::size_t> order(lines.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](std::size_t n) { return rises[n].by_handle(); });
  const auto first = order.begin(),
             last = first + std::ptrdiff_t(std::min(priced_first, lines.size()));
  std::vector<ProposedStep*> cheapest;
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
    ProposedStep& c = *proposals[n];
    c.rise = share_of_expected * of_error * rises[n].root;
    c.price = std::max(c.price, share_of_expected * of_price * rises[n].by_handle());
  });
}

ProposedStep* PlainQueue::first() {
  std::ranges::stable_sort(proposals_, [](const ProposedStep& a, const ProposedStep& b) {
    return std::pair(a.is_too_much, a.price) < std::pair(b.is_too_much, b.price);
  });
  if (proposals_.empty() || proposals_.front().is_too_much) return nullptr;
  return &proposals_.front();
}

std::vector<ProposedStep*> PlainQueue::next_unpriced(
    const std::function<bool(const ProposedStep&)>& is_worth_it) {
  std::vector<ProposedStep*> unpriced;
  for (ProposedStep& c : proposals_)
    if (unpriced.size() < at_once && !is_priced(c) && !c.is_too_much && is_worth_it(c) &&
        c.step.takes_line() == proposals_.front().step.takes_line())
      unpriced.push_back(&c);
  return unpriced;
}

void PlainQueue::keep_one_picture() {
  ProposedStep* cheapest = nullptr;
  for (ProposedStep& c : proposals_) {
    if (!c.outcome) continue;
    ProposedStep* dearer = &c;
    if (!cheapest || c.price < cheapest->price) std::swap(cheapest, dearer);
    if (dearer) dearer->outcome->forget_form();
  }
}

ProposedStep PlainQueue::take_first() {
  ProposedStep taken = std::move(proposals_.front());
  proposals_.erase(proposals_.begin());
  too_much_in_a_row_ = 0;
  note_harmful(*taken.outcome);
  if (taken.step.takes_line())
    renumber_without(taken.step);
  else
    most_sides_ = std::max(most_sides_, 2 * taken.step.sides.size());
  return taken;
}

void PlainQueue::note_harmful(const PlainCandidate& outcome) {
  if (outcome.harmful.empty()) return;
  made_when_too_much_ = std::min(made_when_too_much_, made_);
  for (const Side& side : outcome.harmful) too_much_.push_back({side, made_});
}

void PlainQueue::renumber_without(const Step& gone) {
  for (ProposedStep& c : proposals_)
    if (c.step.along == gone.along && c.step.line > gone.line) --c.step.line;
  std::erase_if(too_much_, [&](TooMuch& too_much) {
    int& at = gone.along == Along::rows ? too_much.side.row : too_much.side.column;
    if (at > gone.line) --at;
    // The sides beside the line are others now.
    return at == gone.line || at == gone.line - 1;
  });
}

void PlainQueue::give_up_first() {
  made_when_too_much_ = std::min(made_when_too_much_, made_);
  ProposedStep& first = proposals_.front();
  first.is_too_much = true;
  const std::optional<PlainCandidate> outcome = std::exchange(first.outcome, std::nullopt);
  if (first.step.takes_line()) return;
  sides_proposed_at_ = -1;
  if (first.step.sides.size() > 1 && outcome && !outcome->harmful.empty()) {
    note_harmful(*outcome);
  } else if (first.step.sides.size() > 1) {
    most_sides_ = smaller_portion(first.step.sides.size());
  } else {
    too_much_.push_back({first.step.sides.front(), made_});
    ++too_much_in_a_row_;
  }
}

}  // namespace gradmesh
