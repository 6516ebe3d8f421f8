#include "error/merge_trial.h"

#include "ops/merge.h"

namespace gradmesh {

bool MergeTrial::try_merge(Halfedge edge) {
  if (!mesh()[edge].alive || can_merge(mesh(), edge) != MergeObstacle::none) return false;
  const std::size_t depth = journal_.depth();
  gradmesh::merge(journal_, edge);
  return keep_if_cheap(depth);
}

bool MergeTrial::try_merge(const std::vector<Region>& regions) {
  const std::size_t depth = journal_.depth();
  merge_possible(regions);
  return journal_.depth() > depth && keep_if_cheap(depth);
}

void MergeTrial::merge(const std::vector<Region>& regions) {
  const std::size_t depth = journal_.depth();
  merge_possible(regions);
  error_.after_edits(journal_, depth);
  error_.accept(journal_);
}

void MergeTrial::merge_possible(const std::vector<Region>& regions) {
  for (const Region& region : regions)
    if (const auto tops = region_tops(mesh(), region); !tops.empty())
      merge_region(journal_, region, tops);
}

bool MergeTrial::keep_if_cheap(std::size_t depth) {
  if (error_.after_edits(journal_, depth, epsilon_) <= epsilon_) {
    error_.accept(journal_);
    return true;
  }
  while (journal_.depth() > depth) journal_.undo();
  return false;
}

double RegionTrial::price(const Region& region, double limit) {
  if (!merger_.merge(region)) return std::numeric_limits<double>::infinity();
  const double before = trial_.error();
  return trial_.error_.after_edits(trial_.journal_, depth_, before + limit) - before;
}

void MergeTrial::undo_all() {
  if (journal_.depth() == 0) return;
  while (journal_.depth() > 0) journal_.undo();
  error_.restore(start_);
}

std::unique_ptr<MergeTrial::Fork> MergeTrial::fork() {
  return std::make_unique<Fork>(mesh(), error_.fork(), epsilon_);
}

}  // namespace gradmesh
