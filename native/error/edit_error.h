#pragma once

#include <memory>
#include <vector>

#include "base/image.h"
#include "metric/metric.h"
#include "ops/journal.h"
#include "raster/rasterizer.h"

namespace gradmesh {

/// The error of an edited mesh against the mesh as it was at first (paper, section 5): the mean
/// of the metric's map over the whole frame. An edit is painted and measured only where it
/// changes something, and the number is that of the whole frame.
class EditError {
 public:
  /// Paints `original`, the reference, and `start`, the mesh that will be edited, as it will be
  /// written. That may cost something before anything is merged: `start` may hold less than the
  /// original, and a translucent mesh of the model `bilinear` has its opacities in a mask.
  EditError(const Mesh& original, const Mesh& start, const Frame& frame, MetricKind metric);

  /// Error of the mesh as last accepted.
  double error() const { return state_.sum / double(state_.map.samples.size()); }

  /// Error of the journal's mesh, which is the accepted one and the operations after the first
  /// `depth`. To be followed by accept() or reject().
  double after_edits(const Journal& journal, std::size_t depth);
  void accept(const Journal& journal);
  void reject();

  /// What has been accepted so far.
  struct State {
    Image image;
    Plane map;
    double sum = 0;
    /// Where each face lies in `image`.
    std::vector<Window> bounds;
  };
  const State& state() const { return state_; }
  /// Goes back to an earlier state, after the journal did.
  void restore(const State& state) { state_ = state; }

  /// Paints and measures everything afresh.
  double whole_frame(const Mesh& mesh) const;

  const Image& reference() const { return reference_; }

 private:
  Window changed_pixels(const Mesh& mesh) const;

  std::unique_ptr<Rasterizer> rasterizer_;
  Frame frame_;
  Image reference_;
  std::unique_ptr<Metric> metric_;

  State state_;

  /// What is on trial, and what it has overwritten.
  struct Trial {
    std::vector<Face> touched;
    Window pixels, measured;
    std::vector<std::uint8_t> image;
    std::vector<float> map;
    double sum;
  };
  Trial trial_;
};

}  // namespace gradmesh
