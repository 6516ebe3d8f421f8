#pragma once

#include "fit/target.h"
#include "fit/unknowns.h"

namespace gradmesh {

/// Fits faces of a mesh to the picture of its original, by least squares in Gauss-Newton steps. As
/// long as it lives, the journal's mesh may change in the values of its unknowns only.
class Fit {
 public:
  Fit(Journal& journal, const FitTarget& target, const std::vector<Face>& faces);

  const std::vector<Unknown>& unknowns() const { return unknowns_; }
  const std::vector<InfluencedFace>& influenced() const { return influenced_; }

  /// By how much to change each unknown of the mesh as it is now. `damping` for each unknown, 0 or
  /// more: the larger, the less it changes.
  std::vector<Value> step(const std::vector<double>& damping) const;
  /// Makes a step, as one operation of the journal; those that are to stay are left out.
  void apply(const std::vector<Value>& step, const std::vector<bool>& stays);

 private:
  Journal& journal_;
  const FitTarget& target_;
  const std::vector<Unknown> unknowns_;
  const std::vector<InfluencedFace> influenced_;
};

}  // namespace gradmesh
