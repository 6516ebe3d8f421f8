#include "methods/merging/merging.h"

#include "mesh/rectangle.h"

namespace gradmesh {
namespace {

/// Takes the last merge back, or all merges of the last line.
void undo_last(MergeTrial& trial, bool keeps_rectangle) {
  do trial.undo_last();
  while (keeps_rectangle && trial.depth() > 0 && !find_grid(trial.mesh()));
}

/// Takes the last merges back, twice as many at each step, until the mesh as it will be written
/// keeps to the bounds. The error as written differs from the selected mesh's by rounding. Returns
/// the mesh that is left if something is left merged.
std::optional<Candidate> take_back(const Problem& problem, MergeTrial& trial,
                                   bool keeps_rectangle) {
  std::optional<Candidate> left;
  for (int at_once = 1; trial.depth() > 0 && !(left && left->keeps); at_once *= 2) {
    for (int i = 0; i < at_once && trial.depth() > 0; ++i) undo_last(trial, keeps_rectangle);
    left = trial.depth() > 0 ? std::optional(problem.measure(trial.mesh())) : std::nullopt;
  }
  trial.measure_again();
  return left;
}

}  // namespace

Candidate merge_what_fits(const Problem& problem, MergeTrial& trial, const Merge& merge,
                          MergingRules rules) {
  std::optional<Candidate> found;
  for (bool goes_on = true; goes_on;) {
    const std::size_t depth = trial.depth();
    PriceTable afresh;
    merge(trial, depth == 0 ? problem.prices() : afresh);
    if (trial.depth() == 0) break;
    found = problem.measure(trial.mesh());
    if (found->keeps) break;
    trial.lower_epsilon(problem.bounds.epsilon - (found->error - trial.error()));
    found = take_back(problem, trial, rules.keeps_rectangle);
    goes_on = trial.depth() > depth && rules.merges_again;
  }
  if (!found) found = problem.unchanged();
  found->error_added_up = trial.error();
  return *std::move(found);
}

}  // namespace gradmesh
