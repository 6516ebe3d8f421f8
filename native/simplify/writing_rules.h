#pragma once

#include "form/written_form.h"
#include "raster/frame.h"

namespace gradmesh {

/// How a document writes a mesh that has been simplified: what a format tells a run.
class WritingRules {
 public:
  virtual ~WritingRules() = default;

  /// The form in which the mesh is written; `frame` is the one in which it is measured. Throws
  /// InputError where a reader would refuse the mesh.
  virtual WrittenForm form(const Mesh& mesh, const Frame& frame) const = 0;

  /// Whether a translucent mesh may be written with its opacities in a mask. A run then charges
  /// that mask to every edit.
  virtual bool may_mask_opacity() const { return false; }
};

}  // namespace gradmesh
