#pragma once

#include <memory>
#include <vector>

#include "error/edit_error.h"
#include "mesh/region.h"
#include "ops/journal.h"

namespace gradmesh {

/// The loop body of the paper's Fig. 3: check what is to be merged, merge it, paint, compare, and
/// keep the merge or take it back.
class MergeTrial {
 public:
  MergeTrial(Mesh& mesh, EditError error, double epsilon)
      : journal_(mesh), error_(std::move(error)), start_(error_.state()), epsilon_(epsilon) {}

  /// Merges the edge if that is possible and the whole error stays at most epsilon.
  bool try_merge(Halfedge edge);

  /// The same for all the patches of all these regions, all or none. Regions that cannot be merged
  /// any more after the others are left out.
  bool try_merge(const std::vector<Region>& regions);

  /// Merges the regions whatever the error is.
  void merge(const std::vector<Region>& regions);

  /// By how much merging the region alone would raise the error of the mesh as it is; some number
  /// above `limit` where it is certain to be above that; infinity where it cannot be merged.
  /// Changes nothing. `tops` as of region_tops.
  double price(const Region& region, const std::vector<Halfedge>& tops,
               double limit = std::numeric_limits<double>::infinity());

  /// Takes everything back.
  void undo_all();
  /// Takes the last merge back without a look at the error: nothing may be tried afterwards.
  void undo_last() { journal_.undo(); }

  const Mesh& mesh() const { return journal_.mesh(); }
  /// Merges that can be taken back.
  std::size_t depth() const { return journal_.depth(); }
  double error() const { return error_.error(); }
  double epsilon() const { return epsilon_; }
  const EditError& measure() const { return error_; }
  /// Merges, of edges or regions, that were painted and measured, here and by all the forks.
  int evaluations() const { return error_.evaluations(); }

  /// A mesh and a trial of its own, as they are here now, for another thread.
  struct Fork;
  std::unique_ptr<Fork> fork();

 private:
  /// Merges those of the regions that can be merged after the ones before them.
  void merge_possible(const std::vector<Region>& regions);
  /// Keeps the operations after the first `depth`, or takes them back if they cost too much.
  bool keep_if_cheap(std::size_t depth);

  Journal journal_;
  EditError error_;
  std::shared_ptr<const EditError::State> start_;
  double epsilon_;
};

struct MergeTrial::Fork {
  Fork(const Mesh& from, EditError error, double epsilon)
      : mesh(from), trial(mesh, std::move(error), epsilon) {}

  Mesh mesh;
  MergeTrial trial;
};

}  // namespace gradmesh
