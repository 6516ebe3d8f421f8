#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "base/affine.h"
#include "base/progress.h"
#include "mesh/mesh.h"
#include "metric/metric.h"
#include "raster/frame.h"

namespace gradmesh {

enum class Method { grid };

struct SimplifyOptions {
  Method method = Method::grid;
  MetricKind metric = MetricKind::flip;
  /// Largest error allowed, 0..1 (paper, section 5).
  double epsilon = 0.01;
  /// Pixels along the longer side of the frame, 16..8192.
  int resolution = 700;
  std::uint64_t seed = 0;
  /// Seconds after which the best mesh so far is taken; 0: no limit.
  double time_budget = 0;
  /// 0: all cores. The result does not depend on it.
  int threads = 0;
  /// From mesh units to what the person sees, up to scale.
  Affine view;
  /// The mesh as a reader will find it, in each way in which it can be written: the error that
  /// counts is that of the first way that keeps to epsilon. Empty: it is written as it is.
  std::function<std::vector<Mesh>(const Mesh&, const Frame&)> ways_to_write;
  ProgressCallback progress;
};

enum class Stopped { done, budget, cancelled, nothing_to_merge };

struct SimplifyResult {
  int patches_before = 0, patches_after = 0;
  /// Error of the surface that will be written, measured on the whole frame.
  double error = 0;
  /// Which of the ways to write it has this error.
  int way = 0;
  int evaluations = 0;
  Stopped stopped = Stopped::done;
  /// Where the time went, in seconds.
  struct Seconds {
    double rasterize = 0, select = 0, verify = 0, total = 0;
  } seconds;
  Frame frame;
};

/// Merges patches of `mesh` while the error against the mesh as given stays at most epsilon.
/// Throws std::invalid_argument where an option is out of range, InputError where the mesh has
/// no size.
SimplifyResult simplify(Mesh& mesh, const SimplifyOptions& options);

/// Names as in options and reports: "grid", "flip", "nothing to merge".
const char* name(Method method);
const char* name(MetricKind metric);
const char* name(Stopped stopped);
/// Throw std::invalid_argument with the names there are.
Method method_named(const std::string& name);
MetricKind metric_named(const std::string& name);

}  // namespace gradmesh
