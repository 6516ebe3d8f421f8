#include "report/report.h"

#include "app/document/mesh_source.h"
#include "app/export/page_on_mesh.h"
#include "app/runs/devices.h"
#include "cli/commands.h"
#include "cli/common_options.h"
#include "cli/progress_bar.h"
#include "files/atomic_file.h"

namespace gradmesh {
namespace {

struct ReportArguments {
  std::filesystem::path before, after, out, original, run;
  std::string id, renderer = name(Renderer::automatic);
  ReportPageOptions options;
  bool quiet = false;
};

void run_report(ReportArguments& a, const CLI::App& command) {
  for (const std::string name : {"metric", "epsilon", "resolution", "color_model"})
    if (command.count(flag_of(name)) > 0) a.options.given.push_back(name);
  const auto before = read_and_warn(a.before), after = read_and_warn(a.after);
  if (!a.run.empty()) {
    a.options.run = read_bytes(a.run);
    a.options.run_name = a.run.string();
  }
  const MeshEntry entry = one_mesh(*before, a.id), entry_after = one_mesh(*after, a.id);
  take_renderer(a.renderer, a.options.pricing);
  const std::unique_ptr<Document> original = take_original(a.original, *before);
  Page page;
  {
    ProgressBar bar(a.quiet);
    a.options.pricing.progress = bar.callback();
    page = page_on_mesh(*before, entry, *after, entry_after, a.options);
  }
  write_bytes(a.out, page_html(page));
}

}  // namespace

void add_report(CLI::App& program) {
  const auto a = std::make_shared<ReportArguments>();
  CLI::App& command = *program.add_subcommand(
      "report", "Make a page that shows a mesh before and after its simplification");
  add_path(command, "BEFORE", a->before, any_document())->required();
  add_path(command, "AFTER", a->after, "The same, simplified")->required();
  add_path(command, "-o,--output", a->out, "HTML page")->required();
  add_id(command, a->id);
  add_path(command, "--run", a->run,
           "What simplify --report wrote: gives the page the options of the run, and this "
           "command their values");
  add_original_option(command, a->original);
  add_options(command, a->options.pricing,
              {"color_model", "metric", "epsilon", "resolution", "visible_only", "threads"});
  add_analysis_options(command, a->options.analyses);
  add_renderer_option(command, a->renderer);
  command.add_flag("--quiet", a->quiet, "Print nothing");
  command.callback([a, &command] { run_report(*a, command); });
}

}  // namespace gradmesh
