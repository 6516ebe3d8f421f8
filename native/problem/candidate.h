#pragma once

#include <memory>

#include "form/counts.h"
#include "form/written_form.h"
#include "mesh/mesh.h"
#include "trial/measured_surface.h"

namespace gradmesh {

/// What could become of a mesh, measured as it will be written (Problem::measure).
struct Candidate {
  Mesh mesh = {};
  /// The form that was measured. Empty if there are no rules of writing, or if nothing was changed.
  WrittenForm form = {};
  /// The surface of that form as it was measured; null where nothing was written.
  std::shared_ptr<const MeasuredSurface> measured = nullptr;
  /// The error of the surface that will be written, measured on the whole frame.
  double error = 0;
  /// The largest mean of the metric's map in any window of 32 x 32 pixels (metric/local_mean.h).
  double local_error = 0;
  /// The largest mean of the map in any window of 4 x 4 pixels away from the outline
  /// (metric/detail_errors.h); 0 where there is no bound of it.
  double detail_error = 0;
  /// True if the errors keep to the bounds.
  bool keeps = true;
  /// True if the mesh was made simpler; otherwise it is as it was, and is not written.
  bool changed = false;
  /// The error of the mesh as selected, added up from the changes by single edits. It equals the
  /// error of the whole frame up to rounding, unless the mesh is written in another form or with
  /// fewer edits.
  double error_added_up = 0;

  /// Returns the mesh as a reader will find it.
  const Mesh& surface() const { return form.surface.face_count() > 0 ? form.surface : mesh; }
  /// Returns how much of the mesh a person will find.
  MeshCounts counts() const { return counts_of(surface()); }
  /// Returns how much a person has to handle: handles, and objects for as many as each is worth.
  int effort() const;
};

}  // namespace gradmesh
