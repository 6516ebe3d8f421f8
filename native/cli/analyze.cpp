#include <cstdio>

#include "app/runs/devices.h"
#include "app/runs/runs.h"
#include "cli/commands.h"
#include "cli/common_options.h"
#include "cli/progress_bar.h"

namespace gradmesh {
namespace {

struct AnalyzeArguments {
  std::filesystem::path in, original;
  std::string renderer = name(Renderer::automatic);
  std::vector<std::string> ids;
  RunOptions options;
  PricePaths analyses;
  bool quiet = false;
};

void run_analyze(AnalyzeArguments& a) {
  take_renderer(a.renderer, a.options);
  const std::unique_ptr<Document> document = read_and_warn(a.in);
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
  add_ids(command, a->ids);
  add_options(command, a->options, {"color_model", "metric", "epsilon", "resolution", "threads"});
  add_path(command, "--load-analysis", a->analyses.load,
           "Take prices from this file, which an earlier run has saved");
  add_renderer_option(command, a->renderer);
  command.add_flag("--quiet", a->quiet, "Print nothing");
  command.callback([a] { run_analyze(*a); });
}

}  // namespace gradmesh
