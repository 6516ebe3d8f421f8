#pragma once

#include "error/edit_error.h"
#include "ops/journal.h"

namespace gradmesh {

/// The loop body of the paper's Fig. 3: check an edge, merge it, paint, compare, and keep the
/// merge or take it back.
class MergeTrial {
 public:
  MergeTrial(Journal& journal, EditError& error, double epsilon)
      : journal_(journal), error_(error), epsilon_(epsilon) {}

  /// Merges the edge if that is possible and the whole error stays at most epsilon.
  bool try_merge(Halfedge edge);

  const Mesh& mesh() const { return journal_.mesh(); }
  double error() const { return error_.error(); }
  /// Merges that were painted and measured.
  int evaluations() const { return evaluations_; }

 private:
  Journal& journal_;
  EditError& error_;
  double epsilon_;
  int evaluations_ = 0;
};

}  // namespace gradmesh
