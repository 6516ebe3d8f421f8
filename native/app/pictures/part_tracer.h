#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "app/document/document_picture.h"
#include "app/pictures/picture_comparison.h"
#include "base/affine.h"
#include "base/image.h"
#include "base/progress.h"
#include "geom/outline.h"
#include "mesh/mesh.h"
#include "trace/shape_target.h"
#include "trace/traced_grid.h"

namespace gradmesh {

struct PartOptions {
  /// As in TraceOptions.
  int handles;
  double epsilon, detail;
  /// True if simpler meshes are made as well (TracedPart::simpler).
  bool wants_simpler = false;
  /// As in TraceOptions.
  std::function<void(const Image&)> show = {};
};

/// A mesh that looks like a part of a picture.
struct TracedPart {
  Mesh mesh;
  int rows, columns;
  /// The numbers of the guides that no line follows.
  std::vector<std::size_t> unused_guides = {};
  /// What is left of it as one line after the other is taken out (trace/thinned_grids.h).
  std::vector<Mesh> simpler = {};
};

/// Makes meshes of one part, and says how far they are from it.
class PartTracer {
 public:
  explicit PartTracer(PicturePart part, const PartOptions& options);

  /// Returns whether a pixel counts.
  bool has_pixels() const { return exact_->pixels() > 0; }
  /// Returns the best mesh of straight lines (trace/traced_grid.h), in its own coordinates.
  TracedPart run(StopWatch& watch) const;

  /// The frame in which meshes are compared with the picture.
  const Frame& frame() const { return exact_->frame(); }
  PictureErrors errors(const Mesh& mesh) const { return exact_->errors(mesh); }
  /// Returns the errors against the picture without what is smaller than the detail.
  PictureErrors errors_without_detail(const Mesh& mesh) const { return coarse_->errors(mesh); }
  bool leaves_detail_out() const { return coarse_ != exact_; }

 private:
  /// What meshes are to look like, and the map from grids over it to the mesh's coordinates.
  struct Goal {
    TargetPicture target;
    ShapeFrame frame;
    Affine place;
  };

  /// The grids with which a trace begins, and for each the guides that it does not follow.
  struct Beginnings {
    std::vector<Beginning> grids;
    std::vector<std::vector<std::size_t>> unused_guides;
  };

  Goal goal() const;
  Goal unweighted_goal() const;
  /// Returns what shows grids over a goal, if that is asked for.
  std::function<void(const LineGrid&)> shower(const Goal& goal) const;
  Beginnings beginnings(const Goal& goal) const;
  /// Returns the grids that follow the shape's outline or the picture's border.
  std::vector<Beginning> unguided_beginnings(const Goal& goal) const;
  /// Returns the shape in pixels of the picture that is followed.
  FilledOutline shape_in_pixels() const;
  std::shared_ptr<const PictureComparison> compared_with(const RgbaImage& image) const;

  const PicturePart part_;
  const PartOptions options_;
  /// The picture without what is smaller than the detail.
  const RgbaImage followed_;
  const std::shared_ptr<const PictureComparison> exact_;
  /// The same where nothing is smaller than the detail.
  const std::shared_ptr<const PictureComparison> coarse_;
};

}  // namespace gradmesh
