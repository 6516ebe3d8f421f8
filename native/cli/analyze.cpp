#include <cstdio>

#include "app/devices.h"
#include "app/runs.h"
#include "cli/commands.h"
#include "cli/common_options.h"
#include "cli/progress_bar.h"

namespace gradmesh {
namespace {

struct AnalyzeArguments {
  std::filesystem::path in, original;
  std::string metric = "flip", renderer = name(Renderer::automatic);
  std::vector<std::string> ids;
  RunOptions options;
  AnalysisPaths analyses;
  bool quiet = false;
};

void run_analyze(AnalyzeArguments& a) {
  a.options.metric = metric_named(a.metric);
  take_renderer(a.renderer, a.options);
  const std::unique_ptr<Document> document = Document::read_file(a.in);
  const std::unique_ptr<Document> original = take_original(a.original, *document);
  std::size_t prices = 0;
  {
    ProgressBar bar(a.quiet);
    a.options.progress = bar.callback();
    prices = analyze(*document, a.ids, a.options, a.analyses);
  }
  if (!a.quiet) std::printf("%s: %zu prices\n", a.analyses.save.string().c_str(), prices);
}

}  // namespace

void add_analyze(CLI::App& program) {
  const auto a = std::make_shared<AnalyzeArguments>();
  CLI::App& command = *program.add_subcommand(
      "analyze", "Work out what merging single edges and regions costs, for later runs");
  add_path(command, "IN", a->in, any_document())->required();
  add_path(command, "-o,--output", a->analyses.save, "Where to write the analysis")->required();
  add_original_option(command, a->original);
  command.add_option("--id", a->ids, "Only this object, or all meshes inside it; may be repeated")
      ->take_all()
      ->expected(1);
  add_color_model_option(command, a->options.color_model);
  add_metric_option(command, a->metric);
  add_epsilon_option(command, a->options.epsilon);
  add_resolution_option(command, a->options.resolution);
  add_path(command, "--load-analysis", a->analyses.load,
           "Take prices from this file, which an earlier run has saved");
  add_threads_option(command, a->options.threads);
  add_renderer_option(command, a->renderer);
  command.add_flag("--quiet", a->quiet, "Print nothing");
  command.callback([a] { run_analyze(*a); });
}

}  // namespace gradmesh
