#include "app/export/page_on_mesh.h"

#include <algorithm>
#include <stdexcept>
#include <tuple>

#include "app/document/frames.h"
#include "base/utf8_path.h"
#include "raster/hidden.h"

namespace gradmesh {
namespace {

using nlohmann::ordered_json;

/// Returns the result of the run for one mesh. Throws InputError if there is none.
ordered_json read_run(const ReportPageOptions& options, const std::string& id) {
  const ordered_json results = ordered_json::parse(*options.run, nullptr, false);
  if (!results.is_object() || !results.contains("meshes") || !results["meshes"].is_array())
    throw InputError("{0}: this is no report of gradmesh simplify.", options.run_name);
  for (const ordered_json& mesh : results["meshes"])
    if (mesh.is_object() && mesh.value("id", "") == id) return mesh;
  throw InputError("{0}: this report says nothing of the mesh {1}.", options.run_name, id);
}

/// Returns the options for pricing: those that were given, otherwise those of the run.
RunOptions pricing_options(const ordered_json& run, const ReportPageOptions& page) {
  RunOptions options = page.pricing;
  const auto is_of_run = [&](const char* name) {
    return run.contains(name) && std::ranges::find(page.given, name) == page.given.end();
  };
  try {
    if (is_of_run("metric")) options.metric = metric_named(run["metric"].get<std::string>());
    if (is_of_run("epsilon")) run["epsilon"].get_to(options.epsilon);
    if (is_of_run("resolution")) run["resolution"].get_to(options.resolution);
    if (is_of_run("color_model"))
      options.color_model = color_model_named(run["color_model"].get<std::string>());
  } catch (const ordered_json::exception&) {
    throw InputError("{0}: this is no report of gradmesh simplify.", page.run_name);
  } catch (const std::invalid_argument& error) {
    throw InputError("{0}: {1}", page.run_name, error.what());
  }
  return options;
}

/// Returns true if the method of the run is the one that fits what it merges.
bool is_of_best(const ordered_json& run) {
  return run.is_object() && run.value("method", "") == best_method;
}

/// Prices the edges and regions of the mesh before.
void price(Page& page, const Problem& problem, const RunOptions& options) {
  // Single edges and regions of a smooth mesh cannot be merged, so they have no prices.
  if (problem.mesh().is_smooth()) return;
  StopWatch watch = watch_of(options);
  page.edges = analyze_edges(problem, watch);
  page.regions = analyze_regions(problem, watch);
  // Takes longer than all the rest, and no other method fits.
  if (is_of_best(page.run)) page.fitted = analyze_fits(problem, page.regions, watch);
}

std::filesystem::path path_of(const Document& document) { return utf8_path(document.name()); }

}  // namespace

Page page_on_mesh(const Document& before, const MeshEntry& entry, const Document& after,
                  const MeshEntry& entry_after, const ReportPageOptions& options) {
  Page page;
  if (options.run) page.run = read_run(options, entry.id);
  PriceFiles files(options.analyses);
  const RunOptions pricing = pricing_options(page.run, options);
  const Problem problem = problem_of(before, entry, pricing, files);
  page.before = {path_of(before).filename().string(), problem.mesh(), {}};
  page.before.objects = before.objects(entry);
  price(page, problem, pricing);
  files.save();

  page.after = {path_of(after).filename().string(), after.mesh(entry_after), {}};
  page.after.objects = after.objects(entry_after);
  Frame &first = page.before.frame, &second = page.after.frame;
  std::tie(first, second) = common_frames(
      {&before, entry, problem.mesh()}, {&after, entry_after, page.after.mesh}, pricing.resolution);
  // What the run did not count is not shown either.
  const Layout layout = layout_of(before, entry, pricing.visible_only);
  if (layout.visible && before.format() == after.format())
    for (Frame* frame : {&first, &second})
      frame->hidden = std::make_shared<HiddenPixels>(*layout.visible, *frame);
  page.id = before.title(entry);
  page.original = problem.original();
  page.metric = pricing.metric;
  page.epsilon = pricing.epsilon;
  return page;
}

}  // namespace gradmesh
