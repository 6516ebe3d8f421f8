#pragma once

#include <functional>
#include <memory>

#include "mesh/mesh.h"
#include "metric/metric.h"
#include "raster/frame.h"

namespace gradmesh {

struct AdaptOptions {
  /// Largest error allowed, 0..1, of a mesh as it will be written. `error_of` returns this error.
  double epsilon = 0.01;
  std::function<double(const Mesh&)> error_of;
  /// The mesh whose picture is the reference, and how errors are measured before a mesh is written.
  std::shared_ptr<const Mesh> original;
  Frame frame;
  MetricKind metric = MetricKind::flip;
};

struct AdaptedMesh {
  Mesh mesh;
  double error = 0;
};

/// Returns the mesh in the colour model `bilinear`, with patches split until the error is at most
/// epsilon. New patches end in T-junctions. The 8-bit colours of the corners are chosen to come
/// close to the original (fit/corner_colors.h). If the error is still too large, twists and
/// tangents are fitted to the picture (trial/fit_trial.h). Returns the mesh with the least error
/// that was found if no number of patches up to the limit (base/limits.h) keeps to epsilon.
AdaptedMesh adapted(const Mesh& mesh, const AdaptOptions& options);

}  // namespace gradmesh
