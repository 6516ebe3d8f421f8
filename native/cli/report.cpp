#include "report/report.h"

#include <filesystem>
#include <stdexcept>

#include <algorithm>
#include "app/common_frames.h"
#include "app/devices.h"
#include "app/one_mesh.h"
#include "cli/commands.h"
#include "cli/common_options.h"
#include "cli/progress_bar.h"
#include "files/atomic_file.h"
#include "raster/hidden.h"

namespace gradmesh {
namespace {

/// Returns true if this is the name of a method that fits what it merges.
bool fits(const std::string& name) {
  return std::ranges::any_of(all_methods(),
                             [&](const Method& m) { return m.name == name && m.fits; });
}

using nlohmann::ordered_json;

struct ReportArguments {
  std::string before, after, out, id, run, original, metric = "flip",
                                                     renderer = name(Renderer::automatic);
  RunOptions options;
  AnalysisPaths analyses;
  bool quiet = false;
};

/// Returns what a report of `simplify` says of one mesh. Throws InputError if it says nothing.
ordered_json run_of(const std::string& path, const std::string& id) {
  const ordered_json report = ordered_json::parse(read_bytes(path), nullptr, false);
  if (!report.is_object() || !report.contains("meshes") || !report["meshes"].is_array())
    throw InputError("{0}: this is no report of gradmesh simplify.", path);
  for (const ordered_json& mesh : report["meshes"])
    if (mesh.is_object() && mesh.value("id", "") == id) return mesh;
  throw InputError("{0}: this report says nothing of the mesh {1}.", path, id);
}

/// Sets `value` to that of the run, unless the option is on the command line.
template <class Value>
void take(const ordered_json& run, const CLI::App& command, const char* key, Value& value) {
  if (command.count(std::string("--") + key) == 0 && run.contains(key)) run[key].get_to(value);
}

void take_options(const ordered_json& run, const CLI::App& command, ReportArguments& a) {
  try {
    take(run, command, "metric", a.metric);
    take(run, command, "epsilon", a.options.epsilon);
    take(run, command, "resolution", a.options.resolution);
    if (!a.options.color_model && run.contains("color_model"))
      a.options.color_model = color_model_named(run["color_model"].get<std::string>());
    a.options.metric = metric_named(a.metric);
  } catch (const ordered_json::exception&) {
    throw InputError("{0}: this is no report of gradmesh simplify.", a.run);
  } catch (const std::invalid_argument& error) {
    throw InputError("{0}: {1}", a.run, error.what());
  }
}

void run_report(ReportArguments& a, const CLI::App& command) {
  const auto before = Document::read_file(a.before), after = Document::read_file(a.after);
  const MeshEntry entry = one_mesh(*before, a.id), entry_after = one_mesh(*after, a.id);
  Report report;
  if (!a.run.empty()) report.run = run_of(a.run, entry.id);
  take_options(report.run, command, a);
  take_renderer(a.renderer, a.options);

  const std::unique_ptr<Document> original = take_original(a.original, *before);
  AnalysisFiles files(a.analyses);
  Document::Start start = before->start(entry, a.options, files);
  // Single edges and regions of a smooth mesh cannot be merged, so they have no prices.
  if (!start.mesh.is_smooth()) {
    ProgressBar bar(a.quiet);
    start.options.progress = bar.callback();
    report.edges = analyze_edges(start.mesh, start.options);
    report.regions = analyze_regions(start.mesh, start.options);
    // Takes longer than all the rest, and no other method fits.
    if (report.run.is_object() && fits(report.run.value("method", "")))
      report.fitted = analyze_fits(start.mesh, start.options, report.regions);
  }
  files.save();

  const Mesh mesh_after = after->mesh(entry_after);
  auto [first, second] =
      common_frames({before.get(), entry, start.mesh}, {after.get(), entry_after, mesh_after},
                    a.options.resolution);
  // What the run did not count is not shown either.
  if (start.options.visible && before->kind() == after->kind())
    for (Frame* frame : {&first, &second})
      frame->hidden = std::make_shared<HiddenPixels>(*start.options.visible, *frame);
  const auto file_name = [](const std::string& path) {
    return std::filesystem::path(path).filename().string();
  };
  // The mesh of a .hemesh file has no name but the file's.
  report.id = before->kind() == DocumentKind::svg ? entry.id
                                                  : std::filesystem::path(a.before).stem().string();
  report.before = {file_name(a.before), start.mesh, first};
  report.after = {file_name(a.after), mesh_after, second};
  report.original = start.options.original.get();
  report.metric = a.options.metric;
  report.epsilon = a.options.epsilon;
  write_bytes(a.out, report_html(report));
}

}  // namespace

void add_report(CLI::App& program) {
  const auto a = std::make_shared<ReportArguments>();
  CLI::App& command = *program.add_subcommand(
      "report", "Make a page that shows a mesh before and after its simplification");
  command.add_option("BEFORE", a->before, "SVG document or .hemesh file")->required();
  command.add_option("AFTER", a->after, "The same, simplified")->required();
  command.add_option("-o,--output", a->out, "HTML page")->required();
  command.add_option("--id", a->id, "Which mesh, where there are several");
  command.add_option(
      "--run", a->run,
      "What simplify --report wrote: gives the page the options of the run, and this "
      "command their values");
  add_original_option(command, a->original);
  add_color_model_option(command, a->options.color_model);
  add_metric_option(command, a->metric);
  add_epsilon_option(command, a->options.epsilon);
  add_resolution_option(command, a->options.resolution);
  add_analysis_options(command, a->analyses);
  add_threads_option(command, a->options.threads);
  add_renderer_option(command, a->renderer);
  add_whole_mesh_option(command, a->options.visible_only);
  command.add_flag("--quiet", a->quiet, "Print nothing");
  command.callback([a, &command] { run_report(*a, command); });
}

}  // namespace gradmesh
