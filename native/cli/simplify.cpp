#include <cstdio>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "app/document/mesh_source.h"
#include "app/document/write_file.h"
#include "app/export/info.h"
#include "app/export/results_json.h"
#include "app/runs/convert.h"
#include "app/runs/curves.h"
#include "app/runs/devices.h"
#include "cli/commands.h"
#include "cli/common_options.h"
#include "cli/progress_bar.h"
#include "files/atomic_file.h"

namespace gradmesh {
namespace {

struct SimplifyArguments {
  std::filesystem::path in, out, original, report, curve;
  PageChoice pages;
  std::optional<int> state;
  std::string renderer = name(Renderer::automatic);
  std::vector<std::string> ids;
  RunOptions options;
  PricePaths analyses;
  WriteOptions writing;
  bool quiet = false, preview = false;
};

/// Returns the document that will be written to OUT, which is IN converted if it is of another
/// format.
std::unique_ptr<Document> to_be_written(std::unique_ptr<Document> in, SimplifyArguments& a) {
  const Format* format = a.preview ? nullptr : format_of(a.out);
  if (!format || *format == in->format()) return in;
  ConvertedRun run = convert_for_run(*in, one_mesh(*in, a.ids), *format, a.options);
  a.options = std::move(run.options);
  a.ids.clear();
  return std::move(run.document);
}

/// Returns what a person is told of the end of a run.
const char* how_it_ended(const SimplifyResult& result) {
  if (result.changed) return name(result.stopped);
  if (result.stopped == Stopped::budget) return "no time left";
  if (result.stopped == Stopped::nothing_to_merge &&
      method_named(result.method).count == Count::handles)
    return "no handle could be taken out";
  return name(result.stopped);
}

void print_results(const std::vector<MeshReport>& reports, const RunOptions& options) {
  for (const auto& [id, r, refused] : reports) {
    if (refused) continue;
    std::printf("%s: %d of %d handles, %d of %d patches left, ", id.c_str(), r.handles_after,
                r.handles_before, r.patches_after, r.patches_before);
    if (const int kept = r.mesh.fixed_face_count())
      std::printf("%d %s protected, ", kept, kept == 1 ? "patch" : "patches");
    if (r.objects > 1) std::printf("%d objects, ", r.objects);
    std::printf("%s %.5f, ", label(options.metric), r.error);
    if (options.max_local_error) std::printf("in small parts up to %.5f, ", r.local_error);
    std::printf("%.2f s (%s)\n", r.seconds.total, how_it_ended(r));
  }
}

/// Returns the JSON that --report writes.
std::string results_text(const Document& document, const std::vector<MeshReport>& reports,
                         const SimplifyArguments& a) {
  nlohmann::ordered_json meshes = nlohmann::ordered_json::array();
  for (const MeshReport& report : reports)
    if (report.refused)
      meshes.push_back({{"id", report.id}, {"refused", report.refused->english()}});
    else
      meshes.push_back(result_json(document, report, a.options, a.original.string()));
  return nlohmann::ordered_json{{"meshes", meshes}}.dump(2) + "\n";
}

void tell_refused(const std::vector<MeshReport>& reports) {
  for (const MeshReport& report : reports)
    if (report.refused)
      std::fprintf(stderr, "gradmesh: left as it was: %s\n", report.refused->english().c_str());
}

/// Finds the curves of the meshes, writes them into a file, and one of their states into the
/// document, as asked.
std::vector<MeshReport> take_state(Document& document, const SimplifyArguments& a) {
  if (!a.out.empty() && !a.state)
    throw InputError("please say with --state which state of the curve is written.");
  PriceFiles files(a.analyses);
  const std::vector<MeshCurve> curves = find_curves(document, a.ids, a.options, files);
  if (!a.curve.empty()) write_bytes(a.curve, curves_json(curves).dump(2) + "\n");
  if (a.out.empty()) return {};
  for (const MeshCurve& c : curves)
    if (const int last = int(c.curve.states.size()) - 1; *a.state > last)
      std::fprintf(stderr, "gradmesh: %s: its curve ends with state %d, which is written.\n",
                   c.entry.id.c_str(), last);
  return write_states(document, curves, *a.state, a.writing);
}

std::vector<MeshReport> run(Document& document, const SimplifyArguments& a) {
  if (!a.curve.empty() || a.state) return take_state(document, a);
  if (a.preview) return preview(document, a.ids, a.options, a.analyses);
  return simplify(document, a.ids, a.options, a.analyses, a.writing);
}

void run_simplify(SimplifyArguments& a) {
  take_renderer(a.renderer, a.options);
  std::unique_ptr<Document> in = read_and_warn(a.in, a.pages);
  const std::unique_ptr<Document> original = take_original(a.original, *in);
  const std::unique_ptr<Document> document = to_be_written(std::move(in), a);
  std::vector<MeshReport> reports;
  {
    ProgressBar bar(a.quiet);
    a.options.progress = bar.callback();
    reports = run(*document, a);
  }
  // The report first: where it cannot be written the document is still as it was.
  if (!a.report.empty()) write_bytes(a.report, results_text(*document, reports, a));
  if (!a.out.empty()) write_file(*document, a.out);
  tell_refused(reports);
  if (!a.quiet) print_results(reports, a.options);
}

/// Adds all options of a run, with what cannot be given together.
void add_run_options(CLI::App& command, RunOptions& options) {
  std::vector<std::string> names;
  for (const OptionEntry& option : all_options()) names.push_back(option.name);
  add_options(command, options, names);
  const auto option = [&](const std::string& name) { return command.get_option(flag_of(name)); };
  option("patches")->excludes(option("handles"));
  option("ratio")->excludes(option("handles"))->excludes(option("patches"));
  for (const std::string& name : replaced_by_amount) option("amount")->excludes(option(name));
}

}  // namespace

void add_simplify(CLI::App& program) {
  const auto a = std::make_shared<SimplifyArguments>();
  CLI::App& command =
      *program.add_subcommand("simplify", "Take out handles and patches while the error allows it");
  add_path(command, "IN", a->in, any_document())->required();
  CLI::App& target = *command.add_option_group("Output")->require_option(1, 2);
  CLI::Option* const out = add_path(target, "-o,--output", a->out, "Where to write the document");
  CLI::Option* const preview = target.add_flag(
      "--preview", a->preview, "Write no document, only say what would become of the meshes");
  CLI::Option* const curve =
      add_path(target, "--curve", a->curve,
               "Write all states as JSON, from the mesh as it is to one that is too simple");
  preview->excludes(out)->excludes(curve);
  add_page_options(command, a->pages);
  add_ids(command, a->ids);
  add_run_options(command, a->options);
  command
      .add_option(
          "--protect", a->options.protect,
          "SVG: do not change patches that this shape covers, even in part; may be repeated")
      ->take_all()
      ->expected(1);
  add_weigh_option(
      command, a->options.weights,
      "SVG: let errors in what this shape covers count so many times, 0.25 to 4, as in "
      "eyes=4; may be repeated, and where shapes overlap the last one counts");
  add_original_option(command, a->original);
  add_renderer_option(command, a->renderer);
  add_analysis_options(command, a->analyses);
  CLI::Option* const state =
      command.add_option("--state", a->state, "Write that state of the curve, from 0")
          ->check(CLI::NonNegativeNumber)
          ->needs(out);
  // A curve has all errors and all numbers of handles.
  for (const std::string& name : replaced_by_amount)
    for (CLI::Option* const of_curve : {curve, state})
      of_curve->excludes(command.get_option(flag_of(name)));
  for (CLI::Option* const of_curve : {curve, state})
    of_curve->excludes(command.get_option("--amount"));
  add_path(command, "--report", a->report, "Write a report as JSON");
  command.add_flag("--keep-original", a->writing.keep_original,
                   "SVG: leave a hidden copy of each object as it was below the result");
  command.add_flag("!--forget-original", a->writing.remember_original,
                   "SVG: keep the file small, without the mesh as it was before");
  command.add_flag("--quiet", a->quiet, "Print nothing");
  command.callback([a] { run_simplify(*a); });
}

}  // namespace gradmesh
