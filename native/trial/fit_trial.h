#pragma once

#include <memory>
#include <vector>

#include "fit/fit.h"
#include "mesh/region.h"
#include "ops/journal.h"
#include "trial/edit_error.h"

namespace gradmesh {

/// Merges regions of a mesh and fits what comes of it to the picture of the original. Eq. 5 keeps
/// the outer tangents and looks at nothing between: it is where a fit starts, and what stays where
/// a fit does not lower the measured error. No fit folds a patch over itself that did not fold.
class FitTrial {
 public:
  /// `error` and `target` of the same original; both start from `mesh`.
  FitTrial(Mesh& mesh, EditError error, std::shared_ptr<const FitTarget> target)
      : journal_(mesh), error_(std::move(error)), target_(std::move(target)) {}

  /// By how much the error rises where the region alone is merged and its patch fitted, or some
  /// number above `limit` where it is above that; infinity where it cannot be merged or breaks the
  /// local bound. The mesh is as before, after.
  double price(const Region& region, double limit);

  /// Merges those of the regions that can be merged after the ones before them, and fits them and
  /// their neighbours in at most so many steps. If the error is then at most `limit` and keeps to
  /// the local bound that stays, otherwise all is as before; which of both.
  bool try_merge(const std::vector<Region>& regions, double limit, int steps);

  /// Fits these faces in at most so many steps, of which those stay that lower the error; none
  /// where together they would break the local bound.
  void improve(const std::vector<Face>& faces, int steps);

  /// How often the mesh was changed for good, and the last time that a face was.
  int changes() const { return changes_; }
  int last_change(Face face) const {
    return std::size_t(face.value) < last_change_.size() ? last_change_[face.value] : 0;
  }

  const Mesh& mesh() const { return journal_.mesh(); }
  double error() const { return error_.error(); }
  int evaluations() const { return error_.evaluations(); }

  /// A mesh and a trial of its own, as they are here now, for another thread.
  struct Fork;
  std::unique_ptr<Fork> fork();

 private:
  /// Merges what can be merged; the faces that came of it.
  std::vector<Face> merge_possible(const std::vector<Region>& regions);
  /// Goes back to an earlier depth, and to the error there.
  void go_back(std::size_t depth, std::shared_ptr<const EditError::State> state);
  void undo_to(std::size_t depth);
  /// Gives up early where the error falls too slowly to come down to `limit` in so many steps.
  void fit(const std::vector<Face>& faces, int steps, double limit);
  /// `unfolded`: the faces that do not fold, and must not.
  bool try_step(Fit& fit, const std::vector<Face>& unfolded, std::vector<double>& damping);

  Journal journal_;
  EditError error_;
  std::shared_ptr<const FitTarget> target_;
  int changes_ = 0;
  std::vector<int> last_change_;
};

struct FitTrial::Fork {
  Fork(Mesh from, EditError error, std::shared_ptr<const FitTarget> target)
      : mesh(std::move(from)), trial(mesh, std::move(error), std::move(target)) {}

  Mesh mesh;
  FitTrial trial;
};

}  // namespace gradmesh
