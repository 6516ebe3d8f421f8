#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "methods/plain/plain_grid.h"
#include "methods/plain/steps.h"
#include "problem/problem.h"

namespace gradmesh {

/// A grid, and what is found of it as it will be written.
struct PlainCandidate {
  PlainGrid grid;
  Candidate written;
  /// Of the sides that were to become straight those that harmed details (harmful_sides), and are
  /// curves again where others stayed straight.
  std::vector<Side> harmful = {};

  /// `near` and `limit` as of Problem::measure.
  PlainCandidate(PlainGrid made, const Problem& problem, const PlainCandidate* near = nullptr,
                 double limit = std::numeric_limits<double>::infinity());

  /// Keeps the grid and its errors alone.
  void forget_form() {
    written.mesh = {};
    written.form = {};
    written.measured.reset();
  }
};

/// A step, and what it led to from the grid of when PlainQueue::made() was `priced_at`.
struct ProposedStep {
  Step step;
  /// By how much the error rises for each handle saved, with a share for the largest error of a
  /// small part, and by how much the error rises in all.
  double price, rise = 0;
  int priced_at = -1;
  std::optional<PlainCandidate> outcome = std::nullopt;
  /// True if the step was found to be too much in this pass.
  bool is_too_much = false;
};

/// The steps that may make a grid plainer, in the order in which they are tried: many sides at once
/// while they are cheap, then lines and sides by price. Whoever fits and measures says what steps
/// cost; a line that has no price yet stands where its equations let expect.
class PlainQueue {
 public:
  using Pricing = std::function<void(const std::vector<ProposedStep*>&)>;

  /// Proposes all lines, at one price until they are expected.
  PlainQueue(const PlainGrid& grid, double line_price);

  /// Returns the number of grids so far, by which it is known of which one something was found.
  int made() const { return made_; }
  /// There is another grid: what was found of proposals is of the one before.
  void begin_grid();

  /// Forgets what was priced and what was too much.
  void forget_prices();
  /// Begins a pass: what was too much is tried again, but for this very grid.
  void begin_pass();
  /// True if steps of this pass were made after others were found to be too much.
  bool has_made_room() const { return made_ > made_when_too_much_; }

  /// Sees to it that one proposal makes sides straight: of all that may still become so, the
  /// cheapest by the sums of squares before anything is fitted, and of these a part at a time.
  void propose_sides(const PlainGrid& grid, const Problem& problem, bool may_be_seen);
  bool are_lines_expected() const { return are_lines_expected_; }
  /// Has the lines priced that are expected to be the cheapest, and gives the others the prices
  /// that these let expect: so each is priced when its turn comes, and most never.
  void expect_lines(const PlainGrid& grid, const Problem& problem, const Pricing& price);

  /// Returns the next proposal to be tried, until one is priced, given up or taken; null if none is
  /// left in this pass.
  ProposedStep* first();
  bool is_priced(const ProposedStep& proposal) const { return proposal.priced_at == made_; }
  /// Returns the first proposal, and with a line the next one, of those that have no price of this
  /// grid and are worth one.
  std::vector<ProposedStep*> next_unpriced(
      const std::function<bool(const ProposedStep&)>& is_worth_it);
  /// Keeps the picture of the cheapest priced proposal, which is likely to be the next: pictures
  /// are large.
  void keep_one_picture();
  /// Returns the first proposal, whose step is made.
  ProposedStep take_first();
  /// Gives up the first proposal in this pass; of several sides fewer are tried.
  void give_up_first();

 private:
  /// A side, and `made_` when it cost too much to be straight.
  struct TooMuch {
    Side side;
    int made;
  };

  void note_harmful(const PlainCandidate& outcome);
  void renumber_without(const Step& gone);

  std::vector<ProposedStep> proposals_;
  /// Sides that cost too much to be straight, in this pass or for this very grid.
  std::vector<TooMuch> too_much_;
  /// The most sides that are made straight at once, in this pass.
  std::size_t most_sides_ = 0;
  /// The number of steps that were made and of fits of the whole, and how many these were when
  /// sides were proposed.
  int made_ = 0, sides_proposed_at_ = -1;
  /// The number that had been made when the first step of this pass was found to be too much.
  int made_when_too_much_ = 0;
  int too_much_in_a_row_ = 0;
  bool are_lines_expected_ = false;
};

}  // namespace gradmesh
