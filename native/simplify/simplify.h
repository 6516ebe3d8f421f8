#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/affine.h"
#include "base/progress.h"
#include "mesh/mesh.h"
#include "methods/edges.h"
#include "methods/method.h"
#include "methods/regions.h"
#include "metric/metric.h"
#include "pricing/price_table.h"
#include "raster/frame.h"
#include "raster/hidden.h"
#include "simplify/writing_rules.h"

namespace gradmesh {

/// What a person may ask for. With the options of the methods, of which the chosen one heeds those
/// that Method::options names.
struct SimplifyOptions : MethodOptions {
  /// The name of a method, or `simplest` (methods/method.h).
  std::string method = simplest;
  MetricKind metric = MetricKind::flip;
  /// Largest error allowed, 0..1 (paper, section 5).
  double epsilon = 0.01;
  /// The largest error allowed in any window of 32 x 32 pixels, 0..1, beside epsilon (LocalBound).
  std::optional<double> max_local_error;
  /// A target instead of epsilon: the largest number of patches that may be left, or their share
  /// of those there are, above 0 and at most 1. The error is then as small as the method finds.
  std::optional<int> patches;
  std::optional<double> ratio;
  /// Pixels along the longer side of the frame, as of check_resolution.
  int resolution = 700;
  /// In which colour model a document's mesh is merged, by default its own (Document::simplify).
  /// simplify() itself takes the mesh's.
  std::optional<ColorModel> color_model;
  /// Seconds after which the best mesh so far is taken; 0: no limit.
  double time_budget = 0;
  /// 0: all cores. The result does not depend on it.
  int threads = 0;
  /// Of a document's mesh (Document::simplify): whether only what is seen of it counts.
  bool visible_only = true;
};

/// The same, and what the machinery needs beside: a document and whoever calls it set that.
struct RunOptions : SimplifyOptions {
  RunOptions(const SimplifyOptions& asked = {}) : SimplifyOptions(asked) {}

  /// From mesh units to what the person sees, up to scale.
  Affine view;
  FramePadding padding;
  /// What is seen of the mesh: the rest does not count, as if it were not painted. All by default.
  std::optional<VisibleArea> visible;
  /// How the mesh will be written: the error of that form is the one that counts. Null: as it is.
  std::shared_ptr<const WritingRules> rules;
  /// The picture that counts, where that is not the mesh as given.
  std::shared_ptr<const Mesh> original;
  /// Prices known from earlier runs; what is priced anew is added. Its key must be that of the
  /// mesh and these options, or it must be empty. May be null.
  PriceTable* analysis = nullptr;
  /// Where regions are priced, many at once; null: on the cores alone. Where it fails they go on,
  /// from where it was, after `device_lost` was called on the calling thread.
  std::shared_ptr<Device> device;
  /// Of a document's mesh (Document::start): a device where it is expected to be faster.
  bool device_if_faster = false;
  MergeTrial::DeviceLost device_lost;
  ProgressCallback progress;
};

enum class Stopped { done, budget, cancelled, nothing_to_merge };

struct SimplifyResult {
  std::string method;
  int patches_before = 0, patches_after = 0;
  /// What a person has to handle, before and as written (form/handles.h).
  int handles_before = 0, handles_after = 0;
  /// The blocks of the group that the mesh becomes, or 1 where it becomes one mesh gradient.
  int objects = 1;
  /// True if the mesh was made simpler; otherwise it is as it was.
  bool changed = false;
  /// Error of the surface that will be written, measured on the whole frame.
  double error = 0;
  /// The largest mean of the same in any window of 32 x 32 pixels (metric/local_mean.h).
  double local_error = 0;
  /// Error of the mesh as selected, added up from what single merges changed. That of the whole
  /// frame but for roundings, unless the mesh is written in another way or with fewer merges.
  double error_added_up = 0;
  int evaluations = 0;
  /// Where regions were priced to the end: the device's name, or "software".
  std::string renderer = "software";
  Stopped stopped = Stopped::done;
  /// Where the time went, in seconds.
  struct Seconds {
    double rasterize = 0, select = 0, verify = 0, total = 0;
  } seconds;
  Frame frame;
  /// The form that was measured, where something was merged and there are rules for it.
  WrittenForm form;
};

/// Merges patches of `mesh` while the error against the original stays at most epsilon, and that of
/// small parts within the local bound; where it is above epsilon from the start, nothing is merged.
/// With a target: until so few are left.
/// Throws std::invalid_argument where an option is out of range or the analysis is another mesh's,
/// InputError where the mesh has no size or covers no pixel, where it is smooth or no rectangle and
/// the method is not for such, or, with `manual`, where an edge cannot be merged within epsilon and
/// the local bound; the mesh is then as it was.
SimplifyResult simplify(Mesh& mesh, const RunOptions& options);

/// The preprocessing alone (B.3): what single edges cost, and the regions that cost at most
/// epsilon, whose prices are all that the methods need. They are added to `options.analysis`, if
/// there is one. Fewer where the time budget ends or the caller cancels. Throw as simplify does.
std::vector<EdgePrice> analyze_edges(const Mesh& mesh, const RunOptions& options);
std::vector<RegionPrice> analyze_regions(const Mesh& mesh, const RunOptions& options);

/// What those regions cost once each is fitted to the picture (methods/best.h), in their order.
/// Throws as simplify does.
std::vector<double> analyze_fits(const Mesh& mesh, const RunOptions& options,
                                 const std::vector<RegionPrice>& regions);

/// The key of the analysis that belongs to this mesh and these options. Throws as simplify does.
PriceTableKey analysis_key(const Mesh& mesh, const RunOptions& options);

/// Throws std::invalid_argument where a resolution is not 16 to the limit on it, in pixels.
void check_resolution(int resolution);

/// Names as in options and reports: "bilinear", "nothing to merge".
const char* name(ColorModel model);
const char* name(Stopped stopped);
/// Throw std::invalid_argument with the names there are.
ColorModel color_model_named(const std::string& name);

}  // namespace gradmesh
