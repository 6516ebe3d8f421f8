#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "fit/fit.h"
#include "mesh/region.h"
#include "ops/journal.h"
#include "trial/edit_error.h"

namespace gradmesh {

/// A way to have fewer handles: a curve, as Mesh::curve names it, becomes straight, or a face a
/// Coons patch.
struct HandleDrop {
  Halfedge curve{};
  Face face{};
};

/// Merges regions of a mesh and fits the merged patches to the picture of the original. Eq. 5 keeps
/// the outer tangents and looks at nothing between: a fit starts from its patch, which stays where
/// the fit does not lower the measured error. No fit folds a patch over itself that did not fold.
class FitTrial {
 public:
  /// `error` starts from `mesh`. If `keeps_plain` is true, fits leave plain what is plain, and move
  /// points (Plainness).
  FitTrial(Mesh& mesh, EditError error, bool keeps_plain = false)
      : journal_(mesh), error_(std::move(error)), keeps_plain_(keeps_plain) {}

  /// Returns by how much the error rises if the region alone is merged and its patch fitted; some
  /// number above `limit` if the rise is above `limit`; infinity if the region cannot be merged or
  /// breaks the local bound. Leaves the mesh as it was.
  double price(const Region& region, double limit);

  /// Merges those of the regions that can be merged after the ones before them, and fits them and
  /// their neighbours in at most `steps` steps. If the error is then at most `limit` and keeps to
  /// the local bound, the mesh stays so, and true is returned; otherwise the mesh is as before.
  bool try_and_fit(const std::vector<Region>& regions, double limit, int steps);

  /// Returns by how much the error rises if handles are dropped and nothing is fitted. Leaves the
  /// mesh as it was.
  double price(const HandleDrop& drop);
  /// Drops handles and fits as try_and_fit does, if `is_kept` says of the fitted mesh that it may
  /// be kept.
  bool try_drops(const std::vector<HandleDrop>& drops, double limit, int steps,
                 const std::function<bool(const Mesh&)>& is_kept);

  /// Fits these faces in at most `steps` steps and keeps the steps that lower the error, but none
  /// if together they would break the local bound.
  void improve(const std::vector<Face>& faces, int steps);

  /// Returns how often merges were kept (try_and_fit), and at the latest of which of these changes
  /// a face was touched, 0 if at none.
  int changes() const { return changes_; }
  int last_change(Face face) const {
    return std::size_t(face.value) < last_change_.size() ? last_change_[face.value] : 0;
  }

  /// A state of the trial, to go back to.
  struct State {
    std::size_t depth = 0;
    std::shared_ptr<const EditError::State> error;
  };
  State state() { return {journal_.depth(), error_.state()}; }
  /// Takes back what was merged and fitted since that state.
  void go_back(const State& state);

  const Mesh& mesh() const { return journal_.mesh(); }
  const Reference& reference() const { return error_.reference(); }
  double error() const { return error_.error(); }
  int evaluations() const { return error_.evaluations(); }

  /// A copy of the mesh and of the trial as they are now, for another thread.
  struct Fork;
  std::unique_ptr<Fork> fork();

 private:
  class Surface;

  /// Merges the regions that can be merged. Returns the merged faces.
  std::vector<Face> merge_possible(const std::vector<Region>& regions);
  /// Keeps the operations after the first `depth`, which changed these faces, once the faces are
  /// fitted, or takes them back. Returns true if they were kept.
  bool keep_if_cheap(std::size_t depth, const std::vector<Face>& changed, double limit, int steps,
                     const std::function<bool(const Mesh&)>& is_kept = {});
  void make(const HandleDrop& drop);
  Plainness plainness() const { return keeps_plain_ ? Plainness(mesh()) : Plainness(); }
  /// Fits the faces in at most `steps` steps. Gives up early if the error falls too slowly to come
  /// down to `limit` in that many steps.
  void fit(const std::vector<Face>& faces, int steps, double limit);

  Journal journal_;
  EditError error_;
  bool keeps_plain_;
  int changes_ = 0;
  std::vector<int> last_change_;
};

struct FitTrial::Fork {
  Fork(Mesh from, EditError error, bool keeps_plain)
      : mesh(std::move(from)), trial(mesh, std::move(error), keeps_plain) {}

  Mesh mesh;
  FitTrial trial;
};

}  // namespace gradmesh
