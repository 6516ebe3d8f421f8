#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/affine.h"
#include "base/progress.h"
#include "form/counts.h"
#include "mesh/mesh.h"
#include "methods/edges.h"
#include "methods/method.h"
#include "methods/regions.h"
#include "metric/metric.h"
#include "pricing/price_table.h"
#include "raster/frame.h"
#include "raster/hidden.h"
#include "simplify/options.h"
#include "simplify/writing_rules.h"

namespace gradmesh {

/// The options of a run with those that a person does not set. The document and the caller of the
/// document set the latter.
struct RunOptions : SimplifyOptions {
  RunOptions(const SimplifyOptions& asked = {}) : SimplifyOptions(asked) {}

  /// The map from mesh units to what the person sees, up to scale.
  Affine view;
  FramePadding padding;
  /// The visible area of the mesh; nothing if all is visible. The rest does not count, as if it
  /// were not painted.
  std::optional<VisibleArea> visible;
  /// The rules by which the mesh will be written. The error of the written form is the one that
  /// counts. Null if the mesh is written as it is.
  std::shared_ptr<const WritingRules> rules;
  /// The mesh whose picture is the reference; null if that is the mesh that is simplified.
  std::shared_ptr<const Mesh> original;
  /// The prices that earlier runs have found. The run adds the prices that it finds. The table's
  /// key must be that of the mesh and these options, or the table must be empty. May be null.
  PriceTable* analysis = nullptr;
  /// The device that prices many regions at once; null for the cores alone. If the device fails,
  /// `device_lost` is called on the calling thread and the cores go on from there.
  std::shared_ptr<Device> device;
  /// True if Document::start sets a device when the device is expected to be faster.
  bool device_if_faster = false;
  MergeTrial::DeviceLost device_lost;
  ProgressCallback progress;
};

enum class Stopped { done, budget, cancelled, nothing_to_merge };

/// Returns the name in reports, such as "nothing to merge".
const char* name(Stopped stopped);

struct SimplifyResult {
  std::string method;
  /// What a person has to handle, before and as written (form/handles.h).
  int handles_before = 0, handles_after = 0;
  int patches_before = 0, patches_after = 0;
  /// The blocks of the group that the mesh becomes, or 1 where it becomes one mesh gradient.
  int objects = 1;
  /// True if the mesh was made simpler; otherwise it is as it was.
  bool changed = false;
  /// The error of the surface that will be written, measured on the whole frame.
  double error = 0;
  /// The largest mean of the metric's map in any window of 32 x 32 pixels (metric/local_mean.h).
  double local_error = 0;
  /// The error of the mesh as selected, added up from the changes by single merges. It equals the
  /// error of the whole frame up to rounding, unless the mesh is written in another form or with
  /// fewer merges.
  double error_added_up = 0;
  int evaluations = 0;
  /// The name of the device that priced regions until the end, or "software".
  std::string renderer = "software";
  Stopped stopped = Stopped::done;
  /// The seconds that each phase took.
  struct Seconds {
    double rasterize = 0, select = 0, verify = 0, total = 0;
  } seconds;
  Frame frame;
  /// The form that was measured. Empty if nothing was merged or if there are no rules.
  WrittenForm form;
};

/// Returns how much a person has to handle of a result: its handles, and its objects for as many as
/// each is worth.
int to_handle(const SimplifyResult& result);

/// Merges patches of `mesh` as long as the error against the original is at most epsilon and the
/// error of small parts keeps to the local bound. Merges nothing if the error is above epsilon from
/// the start. With a target, merges until the target is reached.
///
/// Throws std::invalid_argument if an option is out of range, if options contradict each other, or
/// if the analysis is that of another mesh. Throws InputError if the mesh has no size or covers no
/// pixel, if the method cannot work on the mesh because the mesh is smooth or no rectangle, or if
/// the method is `manual` and an edge cannot be merged within epsilon and the local bound. The mesh
/// is unchanged after an exception.
SimplifyResult simplify(Mesh& mesh, const RunOptions& options);

/// Return the prices of the preprocessing alone (B.3): those of all single edges, and those of the
/// regions that cost at most epsilon, which are all that the methods need. Add the prices to
/// `options.analysis` unless that is null. Return fewer prices if the time budget ends or if the
/// caller cancels. Throw the same exceptions as simplify.
std::vector<EdgePrice> analyze_edges(const Mesh& mesh, const RunOptions& options);
std::vector<RegionPrice> analyze_regions(const Mesh& mesh, const RunOptions& options);

/// Returns the price of each region after the region is fitted to the picture (methods/best.h), in
/// the order of the regions. Throws the same exceptions as simplify.
std::vector<double> analyze_fits(const Mesh& mesh, const RunOptions& options,
                                 const std::vector<RegionPrice>& regions);

/// Returns the key of the analysis that belongs to this mesh and these options. Throws the same
/// exceptions as simplify.
PriceTableKey analysis_key(const Mesh& mesh, const RunOptions& options);

}  // namespace gradmesh
