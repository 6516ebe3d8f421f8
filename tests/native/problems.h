#pragma once

#include <memory>
#include <vector>

#include "simplify/simplify.h"

/// What tests measure meshes against, and prices of meshes on their own.
namespace gradmesh::test {

inline std::shared_ptr<const Reference> reference(const Mesh& original, const Frame& frame,
                                                  MetricKind metric = MetricKind::flip) {
  return std::make_shared<const Reference>(original, frame, metric);
}

inline EditError edit_error(const Mesh& original, const Mesh& start, const Frame& frame,
                            MetricKind metric, bool masks_opacity = true,
                            std::optional<double> max_local_error = std::nullopt) {
  EditError error(reference(original, frame, metric), start, masks_opacity);
  if (max_local_error)
    error.keep_to(std::make_shared<const LocalBound>(*max_local_error, error.state()->map));
  return error;
}

inline Problem problem(const Mesh& mesh, const RunOptions& options) {
  return problem_of(std::make_shared<const Mesh>(mesh), options);
}

inline std::vector<EdgePrice> analyze_edges(const Mesh& mesh, const RunOptions& options) {
  StopWatch watch = watch_of(options);
  return gradmesh::analyze_edges(problem(mesh, options), watch);
}

inline std::vector<RegionPrice> analyze_regions(const Mesh& mesh, const RunOptions& options) {
  StopWatch watch = watch_of(options);
  return gradmesh::analyze_regions(problem(mesh, options), watch);
}

}  // namespace gradmesh::test
