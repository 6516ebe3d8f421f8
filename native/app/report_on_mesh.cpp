#include "app/report_on_mesh.h"

#include <algorithm>
#include <stdexcept>
#include <tuple>

#include "app/common_frames.h"
#include "base/utf8_path.h"
#include "raster/hidden.h"

namespace gradmesh {
namespace {

using nlohmann::ordered_json;

/// Returns what a report of `simplify` says of one mesh. Throws InputError if it says nothing.
ordered_json read_run(const ReportOptions& options, const std::string& id) {
  const ordered_json report = ordered_json::parse(options.run, nullptr, false);
  if (!report.is_object() || !report.contains("meshes") || !report["meshes"].is_array())
    throw InputError("{0}: this is no report of gradmesh simplify.", options.run_name);
  for (const ordered_json& mesh : report["meshes"])
    if (mesh.is_object() && mesh.value("id", "") == id) return mesh;
  throw InputError("{0}: this report says nothing of the mesh {1}.", options.run_name, id);
}

/// Sets `value` to that of the run if there is one.
template <class Value>
void take(const ordered_json& run, const char* key, Value& value) {
  if (run.contains(key)) run[key].get_to(value);
}

/// Returns the options for pricing: those that were given, otherwise those of the run.
RunOptions pricing_options(const ordered_json& run, const ReportOptions& given) {
  RunOptions options = given.pricing;
  std::string metric = name(given.metric.value_or(options.metric));
  options.epsilon = given.epsilon.value_or(options.epsilon);
  options.resolution = given.resolution.value_or(options.resolution);
  try {
    if (!given.metric) take(run, "metric", metric);
    if (!given.epsilon) take(run, "epsilon", options.epsilon);
    if (!given.resolution) take(run, "resolution", options.resolution);
    if (!options.color_model && run.contains("color_model"))
      options.color_model = color_model_named(run["color_model"].get<std::string>());
    options.metric = metric_named(metric);
  } catch (const ordered_json::exception&) {
    throw InputError("{0}: this is no report of gradmesh simplify.", given.run_name);
  } catch (const std::invalid_argument& error) {
    throw InputError("{0}: {1}", given.run_name, error.what());
  }
  return options;
}

/// Returns true if the method of the run is the one that fits what it merges.
bool is_of_best(const ordered_json& run) {
  return run.is_object() && run.value("method", "") == best_method;
}

/// Prices the edges and regions of the mesh before.
void price(Report& report, const Problem& problem, const RunOptions& options) {
  // Single edges and regions of a smooth mesh cannot be merged, so they have no prices.
  if (problem.mesh().is_smooth()) return;
  StopWatch watch = watch_of(options);
  report.edges = analyze_edges(problem, watch);
  report.regions = analyze_regions(problem, watch);
  // Takes longer than all the rest, and no other method fits.
  if (is_of_best(report.run)) report.fitted = analyze_fits(problem, report.regions, watch);
}

std::filesystem::path path_of(const Document& document) { return utf8_path(document.name()); }

}  // namespace

Report report_on_mesh(const Document& before, const MeshEntry& entry, const Document& after,
                      const MeshEntry& entry_after, const ReportOptions& options) {
  Report report;
  if (!options.run.empty()) report.run = read_run(options, entry.id);
  AnalysisFiles files(options.analyses);
  const RunOptions run = pricing_options(report.run, options);
  const Problem problem = problem_of(before, entry, run, files);
  report.before = {path_of(before).filename().string(), problem.mesh(), {}};
  report.before.objects = before.objects(entry);
  price(report, problem, run);
  files.save();

  report.after = {path_of(after).filename().string(), after.mesh(entry_after), {}};
  report.after.objects = after.objects(entry_after);
  Frame &first = report.before.frame, &second = report.after.frame;
  std::tie(first, second) =
      common_frames({&before, entry, problem.mesh()}, {&after, entry_after, report.after.mesh},
                    run.resolution);
  // What the run did not count is not shown either.
  const Layout layout = before.layout(entry, run.visible_only);
  if (layout.visible && before.format() == after.format())
    for (Frame* frame : {&first, &second})
      frame->hidden = std::make_shared<HiddenPixels>(*layout.visible, *frame);
  report.id = before.title(entry);
  if (problem.original().get() != &problem.mesh()) report.original = problem.original();
  report.metric = run.metric;
  report.epsilon = run.epsilon;
  return report;
}

}  // namespace gradmesh
