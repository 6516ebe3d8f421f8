#include "trial/merge_trial.h"

#include "ops/merge/merge.h"

namespace gradmesh {

bool MergeTrial::try_edge(Halfedge edge) {
  if (!mesh()[edge].alive || can_merge(mesh(), edge) != MergeObstacle::none) return false;
  const std::size_t depth = journal_.depth();
  gradmesh::merge(journal_, edge);
  return keep_if_cheap(depth);
}

bool MergeTrial::try_regions(const std::vector<Region>& regions) {
  const std::size_t depth = journal_.depth();
  merge_possible(regions);
  return journal_.depth() > depth && keep_if_cheap(depth);
}

double MergeTrial::try_edges(const std::vector<Halfedge>& edges, double limit) {
  const std::size_t depth = journal_.depth();
  const double error = merge_in_turn(edges) ? error_.after_edits(journal_, depth, epsilon_)
                                            : std::numeric_limits<double>::infinity();
  if (error <= limit && error_.keeps_local_bound()) {
    error_.accept(journal_);
    return error;
  }
  journal_.undo_to(depth);
  return error <= limit ? std::numeric_limits<double>::infinity() : error;
}

void MergeTrial::merge(const std::vector<Region>& regions) {
  const std::size_t depth = journal_.depth();
  merge_possible(regions);
  error_.after_edits(journal_, depth);
  error_.accept(journal_);
}

void MergeTrial::merge_possible(const std::vector<Region>& regions) {
  for (const Region& region : regions) merge_region(journal_, region);
}

bool MergeTrial::merge_in_turn(const std::vector<Halfedge>& edges) {
  for (const Halfedge edge : edges) {
    if (!mesh()[edge].alive || can_merge(mesh(), edge) != MergeObstacle::none) return false;
    gradmesh::merge(journal_, edge);
  }
  return true;
}

bool MergeTrial::keep_if_cheap(std::size_t depth) {
  if (error_.after_edits(journal_, depth, epsilon_) <= epsilon_ && error_.keeps_local_bound()) {
    error_.accept(journal_);
    return true;
  }
  journal_.undo_to(depth);
  return false;
}

double RegionTrial::price(const Region& region, double limit) {
  if (!merger_.merge(region).valid()) return std::numeric_limits<double>::infinity();
  const double before = trial_.error();
  return trial_.error_.after_edits(trial_.journal_, depth_, before + limit) - before;
}

bool RegionTrial::describe(const Region& region, EditTile& tile) {
  if (!merger_.merge(region).valid()) return false;
  trial_.error_.describe(trial_.journal_, depth_, tile);
  return true;
}

void MergeTrial::go_back(const State& state) {
  if (depth() == state.depth) return;
  journal_.undo_to(state.depth);
  error_.restore(state.error);
}

void MergeTrial::measure_again() {
  error_.restore(start_);
  error_.after_edits(journal_, 0);
  error_.accept(journal_);
}

std::unique_ptr<MergeTrial::Fork> MergeTrial::fork() {
  return std::make_unique<Fork>(mesh(), error_.fork(), epsilon_);
}

std::unique_ptr<FitTrial::Fork> MergeTrial::fork_to_fit(bool keeps_plain) {
  return std::make_unique<FitTrial::Fork>(mesh(), error_.fork(), keeps_plain);
}

}  // namespace gradmesh
