#pragma once

#include <optional>
#include <string>

#include "form/counts.h"
#include "mesh/mesh.h"
#include "methods/method.h"
#include "metric/metric.h"

namespace gradmesh {

/// The smallest resolution at which errors are measured, in pixels.
inline constexpr int least_resolution = 16;

/// The options of a run that a person may set. The chosen method heeds those MethodOptions that its
/// Method::options names.
struct SimplifyOptions : MethodOptions {
  /// The name of a method, or `simplest` (methods/method.h).
  std::string method = simplest;
  MetricKind metric = MetricKind::flip;
  /// Largest error allowed, 0..1 (paper, section 5).
  double epsilon = 0.01;
  /// The largest error allowed in any window of 32 x 32 pixels, 0..1, beside epsilon (LocalBound).
  std::optional<double> max_local_error;
  /// A target that replaces epsilon: the largest number of handles or of patches that may be left,
  /// or the share that may be left of what is counted, above 0 and at most 1. The error is then as
  /// small as the method finds.
  std::optional<int> handles, patches;
  std::optional<double> ratio;
  /// What is made few, and what `ratio` is a share of; nothing for what_is_counted()
  /// (simplify/target.h).
  std::optional<Count> count;
  /// Pixels along the longer side of the frame, as of check_resolution.
  int resolution = 700;
  /// The colour model in which a document's mesh is merged (Document::simplify); nothing for the
  /// mesh's own. simplify() itself always uses the mesh's own.
  std::optional<ColorModel> color_model;
  /// The seconds after which the best mesh so far is taken; 0 for no limit.
  double time_budget = 0;
  /// The number of threads; 0 for all cores. The result does not depend on the number.
  int threads = 0;
  /// True if only the visible area of a document's mesh counts (Document::simplify).
  bool visible_only = true;

  bool has_target() const { return handles || patches || ratio; }
};

/// Throws std::invalid_argument if an option is out of range.
void check(const SimplifyOptions& options);

/// Throws std::invalid_argument if the resolution, in pixels, is below 16 or above the limit on
/// resolutions (base/limits.h).
void check_resolution(int resolution);

/// Return the name in options and reports, such as "bilinear".
const char* name(ColorModel model);
const char* name(Count count);
/// Returns what is counted by that name. Throws std::invalid_argument if there is nothing.
Count count_named(const std::string& name);
/// Returns the colour model of that name. Throws std::invalid_argument with the names of all models
/// if there is none.
ColorModel color_model_named(const std::string& name);

}  // namespace gradmesh
