#pragma once

#include <vector>

#include "error/edit_error.h"
#include "mesh/region.h"
#include "ops/journal.h"

namespace gradmesh {

/// The loop body of the paper's Fig. 3: check what is to be merged, merge it, paint, compare, and
/// keep the merge or take it back.
class MergeTrial {
 public:
  MergeTrial(Journal& journal, EditError& error, double epsilon)
      : journal_(journal), error_(error), start_(error.state()), epsilon_(epsilon) {}

  /// Merges the edge if that is possible and the whole error stays at most epsilon.
  bool try_merge(Halfedge edge);

  /// The same for all the patches of all these regions, all or none. Regions that cannot be merged
  /// any more after the others are left out.
  bool try_merge(const std::vector<Region>& regions);

  /// Merges the regions whatever the error is.
  void merge(const std::vector<Region>& regions);

  /// By how much merging the region alone would raise the error of the mesh as it is; infinity
  /// where it cannot be merged. Changes nothing. `tops` as of region_tops.
  double price(const Region& region, const std::vector<Halfedge>& tops);

  /// Takes everything back.
  void undo_all();

  const Mesh& mesh() const { return journal_.mesh(); }
  double error() const { return error_.error(); }
  double epsilon() const { return epsilon_; }
  /// Merges, of edges or regions, that were painted and measured.
  int evaluations() const { return evaluations_; }

 private:
  /// Merges those of the regions that can be merged after the ones before them.
  void merge_possible(const std::vector<Region>& regions);
  /// Keeps the operations after the first `depth`, or takes them back if they cost too much.
  bool keep_if_cheap(std::size_t depth);

  Journal& journal_;
  EditError& error_;
  const EditError::State start_;
  double epsilon_;
  int evaluations_ = 0;
};

}  // namespace gradmesh
