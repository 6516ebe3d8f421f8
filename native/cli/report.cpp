#include "report/report.h"

#include "app/devices.h"
#include "app/one_mesh.h"
#include "app/report_on_mesh.h"
#include "cli/commands.h"
#include "cli/common_options.h"
#include "cli/progress_bar.h"
#include "files/atomic_file.h"

namespace gradmesh {
namespace {

struct ReportArguments {
  std::filesystem::path before, after, out, original;
  std::string id, metric = "flip", renderer = name(Renderer::automatic);
  double epsilon = RunOptions().epsilon;
  int resolution = RunOptions().resolution;
  ReportOptions options;
  bool quiet = false;
};

void run_report(ReportArguments& a, const CLI::App& command) {
  if (command.count("--metric") > 0) a.options.metric = metric_named(a.metric);
  if (command.count("--epsilon") > 0) a.options.epsilon = a.epsilon;
  if (command.count("--resolution") > 0) a.options.resolution = a.resolution;
  const auto before = Document::read_file(a.before), after = Document::read_file(a.after);
  const MeshEntry entry = one_mesh(*before, a.id), entry_after = one_mesh(*after, a.id);
  take_renderer(a.renderer, a.options.pricing);
  const std::unique_ptr<Document> original = take_original(a.original, *before);
  Report report;
  {
    ProgressBar bar(a.quiet);
    a.options.pricing.progress = bar.callback();
    report = report_on_mesh(*before, entry, *after, entry_after, a.options);
  }
  write_bytes(a.out, report_html(report));
}

}  // namespace

void add_report(CLI::App& program) {
  const auto a = std::make_shared<ReportArguments>();
  CLI::App& command = *program.add_subcommand(
      "report", "Make a page that shows a mesh before and after its simplification");
  add_path(command, "BEFORE", a->before, any_document())->required();
  add_path(command, "AFTER", a->after, "The same, simplified")->required();
  add_path(command, "-o,--output", a->out, "HTML page")->required();
  command.add_option("--id", a->id, "Which mesh, where there are several");
  add_path(command, "--run", a->options.run,
           "What simplify --report wrote: gives the page the options of the run, and this "
           "command their values");
  add_original_option(command, a->original);
  add_color_model_option(command, a->options.pricing.color_model);
  add_metric_option(command, a->metric);
  add_epsilon_option(command, a->epsilon);
  add_resolution_option(command, a->resolution);
  add_analysis_options(command, a->options.analyses);
  add_threads_option(command, a->options.pricing.threads);
  add_renderer_option(command, a->renderer);
  add_whole_mesh_option(command, a->options.pricing.visible_only);
  command.add_flag("--quiet", a->quiet, "Print nothing");
  command.callback([a, &command] { run_report(*a, command); });
}

}  // namespace gradmesh
