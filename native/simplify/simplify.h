#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/progress.h"
#include "mesh/mesh.h"
#include "methods/merging/edges.h"
#include "methods/merging/regions.h"
#include "problem/problem.h"
#include "simplify/options.h"

namespace gradmesh {

/// The options of a run with those that a person does not set. The document and the caller of the
/// document set the latter.
struct RunOptions : SimplifyOptions, Layout {
  RunOptions(const SimplifyOptions& asked = {}) : SimplifyOptions(asked) {}

  /// The ids of shapes of the document: patches of which they cover something stay as they are.
  std::vector<std::string> protect;
  /// Areas of the page, as a person sees it, that do the same.
  std::vector<FilledOutline> protect_areas;
  /// In what these shapes of the document cover, errors count so many times, least_weight to
  /// most_weight. Where shapes overlap, the last one counts.
  std::vector<std::pair<std::string, double>> weights;

  /// The rules by which the mesh will be written (Problem).
  std::shared_ptr<const WritingRules> rules, gradient_rules;
  /// What has the picture that counts; null if that is the mesh that is simplified.
  std::shared_ptr<const Original> original;
  /// The prices that earlier runs have found (Pricing::table). The table's key must be that of the
  /// mesh and these options, or the table must be empty. May be null.
  PriceTable* analysis = nullptr;
  /// The device that prices many regions at once; null for the cores alone.
  std::shared_ptr<Device> device;
  /// True if a run takes a device when the device is expected to be faster.
  bool device_if_faster = false;
  MergeTrial::DeviceLost device_lost;
  ProgressCallback progress;
};

enum class Stopped { done, budget, cancelled, nothing_to_merge };

/// Returns the name in reports, such as "nothing to merge".
const char* name(Stopped stopped);

/// What a run has made of a mesh, and how it went.
struct SimplifyResult : Candidate {
  std::string method;
  /// What a person has to handle, before and as written (form/handles.h).
  int handles_before = 0, handles_after = 0;
  int patches_before = 0, patches_after = 0;
  /// The error of the mesh as it was, where it is measured against a picture; else 0.
  double error_before = 0;
  /// The blocks of the group that the mesh becomes, or 1 where it becomes one mesh gradient.
  int objects = 1;
  int evaluations = 0;
  /// The name of the device that priced regions until the end, or "software".
  std::string renderer = "software";
  Stopped stopped = Stopped::done;
  /// The seconds until the original was painted, those after, and all.
  struct Seconds {
    double rasterize = 0, select = 0, total = 0;
  } seconds;
  Frame frame;
};

/// Returns the problem that the options make of a mesh. Throws std::invalid_argument if an option
/// is out of range, if options contradict each other, or if the analysis is that of another mesh.
/// Throws InputError if the mesh has no size.
Problem problem_of(std::shared_ptr<const Mesh> mesh, const RunOptions& options);
/// Returns the watch of a run with these options.
inline StopWatch watch_of(const RunOptions& options) {
  return {options.time_budget, options.progress};
}

/// Returns the candidate that a method has found of a problem as a result, without how it went.
SimplifyResult result_of(const Problem& problem, const Method& method, Candidate found);

/// Makes the mesh of the problem simpler by a method as long as it keeps to the bounds; changes
/// nothing if the error is above epsilon from the start. With a target, goes on until the target is
/// reached, with as small an error as the method finds.
///
/// Throws InputError if the mesh covers no pixel, if the method cannot work on the mesh
/// (Method::why_not), or if the method is `manual` and an edge cannot be merged within epsilon and
/// the local bound.
SimplifyResult simplify(const Problem& problem, const Method& method, StopWatch& watch);
/// Does that for the problem that the options make of a mesh. Throws the exceptions of both; the
/// mesh is unchanged after an exception.
SimplifyResult simplify(Mesh& mesh, const RunOptions& options);

/// Return the prices of the preprocessing alone (B.3): those of all single edges, and those of the
/// regions that cost at most epsilon, which are all that the methods need. Return fewer prices if
/// the watch says so. Throw InputError if the mesh covers no pixel or is smooth.
std::vector<EdgePrice> analyze_edges(const Problem& problem, StopWatch& watch);
std::vector<RegionPrice> analyze_regions(const Problem& problem, StopWatch& watch);
/// Returns the price of each region after the region is fitted to the picture
/// (methods/best/best.h), in the order of the regions. Throws as analyze_regions does.
std::vector<double> analyze_fits(const Problem& problem, const std::vector<RegionPrice>& regions,
                                 StopWatch& watch);

}  // namespace gradmesh
