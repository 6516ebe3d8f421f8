#pragma once

#include "fit/equation_solver.h"
#include "fit/refit.h"
#include "fit/unknowns.h"
#include "reference/reference.h"

namespace gradmesh {

/// Fits faces of a mesh to the picture of its original, by least squares in Gauss-Newton steps. As
/// long as the Fit lives, the journal's mesh may change in the values of its unknowns only.
class Fit {
 public:
  /// What is plain stays so.
  Fit(Journal& journal, const Reference& target, const std::vector<Face>& faces,
      Plainness plain = {});

  const std::vector<Unknown>& unknowns() const { return unknowns_; }
  const std::vector<InfluencedFace>& influenced() const { return influenced_; }

  /// Returns by how much to change each unknown of the mesh as it is now: the larger its damping,
  /// the less.
  std::vector<Value> step(const Damping& damping);
  /// Makes a step, as one operation of the journal. Unknowns for which `stays` is true are left
  /// out.
  void apply(const std::vector<Value>& step, const std::vector<bool>& stays);

 private:
  Journal& journal_;
  const Reference& target_;
  const Plainness plain_;
  const std::vector<Unknown> unknowns_;
  const std::vector<InfluencedFace> influenced_;
  EquationSolver solver_;
};

}  // namespace gradmesh
