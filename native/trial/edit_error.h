#pragma once

#include <atomic>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "base/image.h"
#include "device/device_errors.h"
#include "ops/journal.h"
#include "raster/edit_tile.h"
#include "raster/painter.h"
#include "reference/reference.h"
#include "trial/local_bound.h"
#include "trial/measured_surface.h"

namespace gradmesh {

/// The error of an edited mesh against the mesh as it was at first (paper, section 5): the mean of
/// the metric's map over the whole frame. An edit is painted and measured only where it changes
/// what has been accepted so far; the error is that of the whole frame.
class EditError {
 public:
  /// Paints `start`, the mesh that will be edited, as it will be written. The error may be above 0
  /// before anything is merged: `start` may hold less than the original, and a translucent mesh of
  /// the model `bilinear` has its opacities in a mask, unless `masks_opacity` is false.
  /// `is_original` is true if the reference was painted of `start`, which then need not be painted
  /// again.
  EditError(std::shared_ptr<const Reference> reference, const Mesh& start,
            bool masks_opacity = true, bool is_original = false);

  /// Sets the bound of the error of small parts, for this EditError and the forks made from now on;
  /// null for none.
  void keep_to(std::shared_ptr<const LocalBound> bound) { local_bound_ = std::move(bound); }

  /// Returns an EditError for another thread, with the same reference, that goes on from what this
  /// one has accepted. Neither sees what the other does.
  EditError fork();

  const Reference& reference() const { return *fixed_->reference; }
  /// Returns the number of pixels of the frame.
  std::size_t pixels() const { return state_->map.pixels(); }
  /// Returns the error of the mesh as last accepted.
  double error() const { return state_->sum / double(state_->map.pixels()); }

  /// Returns the error of the journal's mesh, which is the accepted mesh changed by the operations
  /// after the first `depth`. Once the error is certain to be above `limit` it is not worked out
  /// further, and some number above `limit` is returned.
  double after_edits(const Journal& journal, std::size_t depth,
                     double limit = std::numeric_limits<double>::infinity());
  /// Returns by how much the edits of the last after_edits, whose error was at most its limit,
  /// changed the sum of the map over the pixels of each face on top, by slots of the faces of the
  /// journal's mesh.
  std::vector<double> change_by_face(std::size_t face_slots) const;
  /// Returns the bound of the error of small parts; null if there is none.
  const LocalBound* local_bound() const { return local_bound_.get(); }
  /// Returns true if the mesh of the last after_edits, whose error must be at most its limit, keeps
  /// to the local bound.
  bool keeps_local_bound();
  /// Returns true if the accepted mesh keeps to the local bound.
  bool accepted_keeps_local_bound() const {
    return !local_bound_ || local_bound_->holds(state_->map);
  }
  /// Accepts the journal's mesh, which must be that of the last after_edits, with an error of at
  /// most its limit.
  void accept(const Journal& journal);

  /// The accepted state: the mesh's painting and its map.
  struct State {
    Painting painting;
    Plane map;
    double sum = 0;
    /// The pixels that each face may cover in the painting, by slots.
    std::vector<Window> bounds;
    /// False only where no face lies over another anywhere.
    bool overlaps = false;
  };
  std::shared_ptr<const State> state();
  /// Goes back to an earlier state, after the journal has gone back to it.
  void restore(std::shared_ptr<const State> state);

  /// Paints and measures the whole frame afresh, with opacities in a mask as for all edits.
  FrameError whole_frame(const Mesh& mesh) const {
    return MeasuredSurface(reference(), mesh, fixed_->frame.masked_opacity, local_bound()).error();
  }

  /// Returns a DeviceErrors that measures many edits at once, starting from what has been accepted
  /// so far. Throws DeviceError.
  std::unique_ptr<DeviceErrors> on_device(std::shared_ptr<Device> device);
  /// Describes the operations of the journal after the first `depth` as an edit for a DeviceErrors.
  /// The edit counts as an evaluation.
  void describe(const Journal& journal, std::size_t depth, EditTile& tile);

  /// Returns the number of edits that were painted and measured, by this EditError and all its
  /// forks.
  int evaluations() const { return fixed_->evaluations; }

 private:
  /// The part that does not change and is shared with the forks.
  struct Fixed {
    std::shared_ptr<const Reference> reference;
    /// That of the reference, and whether opacities are in a mask.
    Frame frame;
    mutable std::atomic<int> evaluations = 0;
  };
  EditError(std::shared_ptr<const Fixed> fixed, std::shared_ptr<const LocalBound> bound,
            std::shared_ptr<const State> state)
      : fixed_(std::move(fixed)), local_bound_(std::move(bound)), state_(std::move(state)) {}

  /// Returns the pixels that the faces touched may change.
  Window changed_pixels(const Mesh& mesh, const std::vector<Face>& touched) const;

  std::shared_ptr<const Fixed> fixed_;
  std::shared_ptr<const LocalBound> local_bound_;
  std::shared_ptr<const State> state_;
  /// The value of `state_` if no other object shares it, so that it may be changed; else null.
  std::shared_ptr<State> own_state_;

  Painter painter_;
  EditTiler tiler_;
  /// The edit on trial: a copy of the part of the state that the edit changes and of what lies
  /// around.
  struct Trial {
    std::vector<Face> touched;
    Window pixels, measured;
    Painting painting;
    Plane map, map_around;
    double sum = 0;
  };
  Trial trial_;
};

}  // namespace gradmesh
