#include "app/page_on_mesh.h"

#include <algorithm>
#include <stdexcept>
#include <tuple>

#include "app/common_frames.h"
#include "base/utf8_path.h"
#include "raster/hidden.h"

namespace gradmesh {
namespace {

using nlohmann::ordered_json;

/// Returns the result of the run for one mesh. Throws InputError if there is none.
ordered_json read_run(const PageOptions& options, const std::string& id) {
  const ordered_json results = ordered_json::parse(*options.run, nullptr, false);
  if (!results.is_object() || !results.contains("meshes") || !results["meshes"].is_array())
    throw InputError("{0}: this is no report of gradmesh simplify.", options.run_name);
  for (const ordered_json& mesh : results["meshes"])
    if (mesh.is_object() && mesh.value("id", "") == id) return mesh;
  throw InputError("{0}: this report says nothing of the mesh {1}.", options.run_name, id);
}

/// Returns the options for pricing: those that were given, otherwise those of the run.
RunOptions pricing_options(const ordered_json& run, const PageOptions& page) {
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

/// Returns true if the method of the run fits what it merges.
bool fits(const ordered_json& run) {
  if (!run.is_object()) return false;
  const std::string method = run.value("method", "");
  return std::ranges::any_of(all_methods(),
                             [&](const Method& m) { return m.name == method && m.fits; });
}

/// Prices the edges and regions of the mesh before.
void price(Page& page, const RunOptions& options) {
  const Mesh& mesh = page.before.mesh;
  // Single edges and regions of a smooth mesh cannot be merged, so they have no prices.
  if (mesh.is_smooth()) return;
  page.edges = analyze_edges(mesh, options);
  page.regions = analyze_regions(mesh, options);
  // Takes longer than all the rest, and no other method fits.
  if (fits(page.run)) page.fitted = analyze_fits(mesh, options, page.regions);
}

std::filesystem::path path_of(const Document& document) { return utf8_path(document.name()); }

}  // namespace

Page page_on_mesh(const Document& before, const MeshEntry& entry, const Document& after,
                  const MeshEntry& entry_after, const PageOptions& options) {
  Page page;
  if (options.run) page.run = read_run(options, entry.id);
  AnalysisFiles files(options.analyses);
  const Document::Start start = before.start(entry, pricing_options(page.run, options), files);
  page.before = {path_of(before).filename().string(), start.mesh, {}};
  page.before.objects = before.objects(entry);
  price(page, start.options);
  files.save();

  page.after = {path_of(after).filename().string(), after.mesh(entry_after), {}};
  page.after.objects = after.objects(entry_after);
  Frame &first = page.before.frame, &second = page.after.frame;
  std::tie(first, second) =
      common_frames({&before, entry, start.mesh}, {&after, entry_after, page.after.mesh},
                    start.options.resolution);
  // What the run did not count is not shown either.
  if (start.options.visible && before.format() == after.format())
    for (Frame* frame : {&first, &second})
      frame->hidden = std::make_shared<HiddenPixels>(*start.options.visible, *frame);
  page.id = before.title(entry);
  page.original = start.options.original;
  page.metric = start.options.metric;
  page.epsilon = start.options.epsilon;
  return page;
}

}  // namespace gradmesh
