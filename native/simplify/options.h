#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "form/counts.h"
#include "mesh/mesh.h"
#include "methods/method.h"
#include "metric/metric.h"

namespace gradmesh {

/// The smallest resolution at which errors are measured, in pixels.
inline constexpr int least_resolution = 16;

/// Pixels along the longer side of a mesh at which its error is measured where nobody asks for
/// another number.
inline constexpr int usual_resolution = 700;

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
  /// The largest error allowed in any window of 4 x 4 pixels away from the outline, 0..1, beside
  /// epsilon (metric/detail_errors.h).
  std::optional<double> max_detail_error;
  /// A target that replaces epsilon: the largest number of handles or of patches that may be left,
  /// or the share that may be left of what is counted, above 0 and at most 1. The error is then as
  /// small as the method finds.
  std::optional<int> handles, patches;
  std::optional<double> ratio;
  /// What is made few, and what `ratio` is a share of; nothing for what_is_counted()
  /// (simplify/target.h).
  std::optional<Count> count;
  /// Pixels along the longer side of the frame, as of check_resolution.
  int resolution = usual_resolution;
  /// The colour model in which a document's mesh is merged (app/runs/runs.h); nothing for the
  /// mesh's own. simplify() itself always uses the mesh's own.
  std::optional<ColorModel> color_model;
  /// The seconds after which the best mesh so far is taken; 0 for no limit.
  double time_budget = 0;
  /// The number of threads; 0 for all cores. The result does not depend on the number.
  int threads = 0;
  /// True if only the visible area of a document's mesh counts (app/runs/runs.h).
  bool visible_only = true;

  bool has_target() const { return handles || patches || ratio; }
};

/// The values of an option that are chosen by name, such as methods.
struct NamedValue {
  std::vector<std::string> (*names)();
  /// Returns the name of the value in the options; empty if there is none.
  std::string (*get)(const SimplifyOptions& options);
  /// Throws std::invalid_argument with all names if there is nothing of that name.
  void (*set)(SimplifyOptions& options, const std::string& name);
};

/// An option of a run as the rest of the program knows it: command line, service, Python and the
/// test of the dialogs take names, defaults and ranges from here. The default is the member's.
struct OptionEntry {
  /// The name in Python and in the dialogs, such as "max_local_error". On the command line it has
  /// "-" for "_".
  std::string name;
  /// What the help of the command line says. The names of the methods that heed the option, where
  /// not all of them do, come before it.
  std::string help;
  std::variant<bool SimplifyOptions::*, int SimplifyOptions::*, std::uint64_t SimplifyOptions::*,
               double SimplifyOptions::*, std::optional<int> SimplifyOptions::*,
               std::optional<double> SimplifyOptions::*, std::vector<int> SimplifyOptions::*,
               NamedValue>
      value;
  /// The values that are allowed. Nothing if simplify() checks the value itself.
  struct Range {
    double least = 0, most = std::numeric_limits<double>::infinity();
    /// What a refusal calls the option and its unit, such as " pixels".
    std::string label, unit = "";
  };
  std::optional<Range> range = std::nullopt;
};

/// Returns all options of a run, in the order in which they are read: the metric comes before the
/// amount, whose bounds depend on it.
const std::vector<OptionEntry>& all_options();

/// Returns the option of that name, which must be one of all_options().
const OptionEntry& option_named(const std::string& name);

/// How much may change, by a name: the largest errors by FLIP, as of SimplifyOptions::epsilon and
/// max_local_error and max_detail_error.
struct Amount {
  const char* name;
  double epsilon, max_local_error, max_detail_error;
  /// The largest error by FLIP of a mesh that is traced (app/pictures/trace.h), against its
  /// picture.
  double traced_epsilon;
};

/// Returns all amounts, the least first. Of FLIP a person sees 0.01 hardly and 0.05 at once
/// (paper, section 5). The errors of small parts are bounded so that no eye or highlight is given
/// up for calm areas elsewhere: highlights go at 0.2 to 0.5, thin ones in part from 0.12, corners
/// of a mouth lose their colour at 0.18, and at 0.1 a change is found only beside the original. In
/// windows of 4 x 4 pixels, ridges of a landscape are polygons at 0.4 and spots have corners at
/// 0.19; where at most 0.13 was found, nobody saw anything at twice the size. What is traced has
/// about 0.02 more: one level everywhere, which nobody sees, is 0.03 by itself. Its windows of 32 x
/// 32 pixels reach about 0.12 at 0.03, and up to twice that at 0.04.
const std::vector<Amount>& all_amounts();

/// Returns the amount of that name. Throws std::invalid_argument with the names of all amounts if
/// there is none.
const Amount& amount_named(const std::string& name);

/// Returns the bounds of an amount by a metric.
Bounds bounds_of(const Amount& amount, MetricKind metric);

/// The options that an amount sets or that replace it, so that none is given beside an amount.
inline const std::vector<std::string> replaced_by_amount = {
    "epsilon", "max_local_error", "max_detail_error", "handles", "patches", "ratio"};

/// Throws std::invalid_argument if an option is out of range.
void check(const SimplifyOptions& options);

/// Throws std::invalid_argument if the resolution, in pixels, is below 16 or above the limit on
/// resolutions (base/limits.h).
void check_resolution(int resolution);

/// Return the name in options and reports, such as "bilinear".
const char* name(ColorModel model);
const char* name(Count count);
/// Returns the colour model of that name. Throws std::invalid_argument with the names of all models
/// if there is none.
ColorModel color_model_named(const std::string& name);

}  // namespace gradmesh
