#include <cstdio>

#include "app/convert_for_run.h"
#include "app/devices.h"
#include "app/one_mesh.h"
#include "cli/commands.h"
#include "cli/common_options.h"
#include "cli/json_output.h"
#include "cli/progress_bar.h"
#include "files/atomic_file.h"

namespace gradmesh {
namespace {

struct SimplifyArguments {
  std::filesystem::path in, out, original, report;
  std::string count, metric = "flip", renderer = name(Renderer::automatic);
  std::vector<std::string> ids;
  RunOptions options;
  AnalysisPaths analyses;
  WriteOptions writing;
  /// Accepted, but changes nothing.
  bool visible_only = false;
  bool quiet = false, preview = false;
};

/// Returns the names of the methods that heed an option, as in the help: "gqe, best: ".
std::string heeding(const std::string& option) {
  std::string names;
  for (const std::string& name : methods_with(option))
    names.append(names.empty() ? "" : ", ").append(name);
  return names + ": ";
}

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
  if (result.stopped == Stopped::nothing_to_merge && method_named(result.method).count == Count::handles)
    return "no handle could be taken out";
  return name(result.stopped);
}

void print_results(const std::vector<MeshReport>& reports, const RunOptions& options) {
  for (const auto& [id, r, refused] : reports) {
    if (refused) continue;
    std::printf("%s: %d of %d handles, %d of %d patches left, ", id.c_str(), r.handles_after,
                r.handles_before, r.patches_after, r.patches_before);
    if (r.objects > 1) std::printf("%d objects, ", r.objects);
    std::printf("%s %.5f, ", label(options.metric), r.error);
    if (options.max_local_error) std::printf("in small parts up to %.5f, ", r.local_error);
    std::printf("%.2f s (%s)\n", r.seconds.total, how_it_ended(r));
  }
}

void tell_refused(const std::vector<MeshReport>& reports) {
  for (const MeshReport& report : reports)
    if (report.refused)
      std::fprintf(stderr, "gradmesh: left as it was: %s\n", report.refused->english().c_str());
}

void run_simplify(SimplifyArguments& a) {
  a.options.metric = metric_named(a.metric);
  if (!a.count.empty()) a.options.count = count_named(a.count);
  take_renderer(a.renderer, a.options);
  std::unique_ptr<Document> in = Document::read_file(a.in);
  const std::unique_ptr<Document> original = take_original(a.original, *in);
  const std::unique_ptr<Document> document = to_be_written(std::move(in), a);
  if (!a.options.color_model) a.options.color_model = document->color_model();
  std::vector<MeshReport> reports;
  {
    ProgressBar bar(a.quiet);
    a.options.progress = bar.callback();
    reports = a.preview ? preview(*document, a.ids, a.options, a.analyses)
                        : simplify(*document, a.ids, a.options, a.analyses, a.writing);
  }
  // The report first: where it cannot be written the document is still as it was.
  if (!a.report.empty())
    write_bytes(a.report, report_json(reports, a.options, a.original.string()).dump(2) + "\n");
  if (!a.preview) document->write_file(a.out);
  tell_refused(reports);
  if (!a.quiet) print_results(reports, a.options);
}

void add_target_options(CLI::App& command, SimplifyArguments& a) {
  CLI::Option* handles =
      command.add_option("--handles", a.options.handles,
                         "Instead of --epsilon: at most so many handles, with the least error");
  CLI::Option* patches =
      command
          .add_option("--patches", a.options.patches,
                      "Instead of --epsilon: at most so many patches, with the least error")
          ->excludes(handles);
  command
      .add_option("--ratio", a.options.ratio,
                  "Instead of --epsilon: this share of the handles, or of the patches")
      ->excludes(handles)
      ->excludes(patches);
  command
      .add_option("--count", a.count,
                  "What is made few, and what --ratio is a share of; by default the handles of an "
                  "SVG document, and patches where a method that merges is named")
      ->check(CLI::IsMember({name(Count::handles), name(Count::patches)}));
}

}  // namespace

void add_simplify(CLI::App& program) {
  const auto a = std::make_shared<SimplifyArguments>();
  CLI::App& command =
      *program.add_subcommand("simplify", "Take out handles and patches while the error allows it");
  add_path(command, "IN", a->in, any_document())->required();
  CLI::App& target = *command.add_option_group("Output")->require_option(1);
  add_path(target, "-o,--output", a->out, "Where to write the document");
  target.add_flag("--preview", a->preview,
                  "Write no document, only say what would become of the meshes");
  command.add_option("--id", a->ids, "Only this object, or all meshes inside it; may be repeated")
      ->take_all()
      ->expected(1);
  command.add_option("--method", a->options.method, "How edges are chosen")
      ->check(CLI::IsMember(method_choices()))
      ->capture_default_str();
  add_color_model_option(command, a->options.color_model);
  add_metric_option(command, a->metric);
  add_epsilon_option(command, a->options.epsilon);
  command
      .add_option("--max-local-error", a->options.max_local_error,
                  "Largest error allowed in any window of 32 x 32 pixels, so that small details "
                  "stay")
      ->check(CLI::Range(0.0, 1.0));
  add_target_options(command, *a);
  add_original_option(command, a->original);
  add_resolution_option(command, a->options.resolution);
  add_whole_mesh_option(command, a->options.visible_only);
  command.add_flag("--visible-only", a->visible_only, "What is done anyway; for older scripts");
  command.add_option("--seed", a->options.seed, "Random choices follow it")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command
      .add_option("--omega", a->options.omega, heeding("omega") + "weight of size against error")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  add_kappa_option(command, a->options.kappa);
  command.add_option("--edges", a->options.edges, "manual: the half-edges to merge, in this order")
      ->delimiter(',');
  command
      .add_option("--time-budget", a->options.time_budget,
                  "Seconds a mesh may take, then the best so far is kept; 0: no limit")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  add_threads_option(command, a->options.threads);
  add_renderer_option(command, a->renderer);
  add_analysis_options(command, a->analyses);
  add_path(command, "--report", a->report, "Write a report as JSON");
  command.add_flag("--keep-original", a->writing.keep_original,
                   "SVG: leave a hidden copy of each object as it was below the result");
  command.add_flag("!--forget-original", a->writing.remember_original,
                   "SVG: keep the file small, without the mesh as it was before");
  command.add_flag("--quiet", a->quiet, "Print nothing");
  command.callback([a] { run_simplify(*a); });
}

}  // namespace gradmesh
