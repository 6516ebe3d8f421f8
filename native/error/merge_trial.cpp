#include "error/merge_trial.h"

#include "ops/merge.h"

namespace gradmesh {

bool MergeTrial::try_merge(Halfedge edge) {
  if (!journal_.mesh()[edge].alive || can_merge(journal_.mesh(), edge) != MergeObstacle::none)
    return false;
  merge(journal_, edge);
  ++evaluations_;
  if (error_.after_edit(journal_) <= epsilon_) {
    error_.accept(journal_);
    return true;
  }
  error_.reject();
  journal_.undo();
  return false;
}

}  // namespace gradmesh
