#pragma once

#include <functional>
#include <memory>

#include "mesh/mesh.h"
#include "metric/metric.h"
#include "raster/frame.h"

namespace gradmesh {

struct AdaptOptions {
  /// Largest error allowed, 0..1, of a mesh as it will be written: what `error_of` says of it.
  double epsilon = 0.01;
  std::function<double(const Mesh&)> error_of;
  /// The picture that counts, and how it is measured before anything is written.
  std::shared_ptr<const Mesh> original;
  Frame frame;
  MetricKind metric = MetricKind::flip;
};

struct AdaptedMesh {
  Mesh mesh;
  double error = 0;
};

/// The mesh in the colour model `bilinear`, its patches split where that is needed until the error
/// is at most epsilon. New patches end in T-junctions; the 8-bit colours of corners are chosen to
/// come close (fit/corner_colors.h), and where that is not enough twists and tangents are fitted to
/// the picture (trial/fit_trial.h). Where no number of patches up to the limit (base/limits.h)
/// keeps to epsilon, that with the least error that was found.
AdaptedMesh adapted(const Mesh& mesh, const AdaptOptions& options);

}  // namespace gradmesh
