#pragma once

#include "form/written_form.h"
#include "raster/frame.h"

namespace gradmesh {

/// The rules by which a document writes a mesh that has been simplified.
class WritingRules {
 public:
  virtual ~WritingRules() = default;

  /// Returns the form in which the mesh is written. The mesh is measured in `frame`. Throws
  /// InputError if a reader would refuse the written mesh.
  virtual WrittenForm form(const Mesh& mesh, const Frame& frame) const = 0;

  /// Returns true if the other rules are known to write every mesh in the same form.
  virtual bool are_like(const WritingRules& /*other*/) const { return false; }

  /// Returns true if a translucent mesh may be written with its opacities in a mask. A run then
  /// charges the mask to every edit.
  virtual bool may_mask_opacity() const { return false; }
};

}  // namespace gradmesh
