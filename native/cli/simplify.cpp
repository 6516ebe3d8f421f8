#include <cstdio>

#include "cli/commands.h"
#include "cli/common_options.h"
#include "cli/json_output.h"
#include "cli/progress_bar.h"
#include "io/atomic_file.h"

namespace gradmesh {
namespace {

struct SimplifyArguments {
  std::string in, out, report, method = "grid", metric = "flip";
  std::vector<std::string> ids;
  SimplifyOptions options;
  bool quiet = false;
};

void run_simplify(SimplifyArguments& a) {
  a.options.method = method_named(a.method);
  a.options.metric = metric_named(a.metric);
  const std::unique_ptr<Document> document = Document::read_file(a.in);
  std::vector<MeshReport> reports;
  {
    ProgressBar bar(a.quiet);
    a.options.progress = bar.callback();
    reports = document->simplify(a.ids, a.options);
  }
  // The report first: where it cannot be written the document is still as it was.
  if (!a.report.empty()) write_bytes(a.report, report_json(reports, a.options).dump(2) + "\n");
  document->write_file(a.out);
  if (a.quiet) return;
  for (const auto& [id, r] : reports)
    std::printf("%s: %d of %d patches left, %s %.5f, %.2f s (%s)\n", id.c_str(), r.patches_after,
                r.patches_before, a.options.metric == MetricKind::flip ? "FLIP" : "1 - SSIM",
                r.error, r.seconds.total, name(r.stopped));
}

}  // namespace

void add_simplify(CLI::App& program) {
  const auto a = std::make_shared<SimplifyArguments>();
  CLI::App& command =
      *program.add_subcommand("simplify", "Merge patches while the error allows it");
  command.add_option("IN", a->in, "SVG document or .hemesh file")->required();
  command.add_option("-o,--output", a->out, "Where to write the document")->required();
  command.add_option("--id", a->ids, "Only this object, or all meshes inside it; may be repeated")
      ->take_all()
      ->expected(1);
  command.add_option("--method", a->method, "How edges are chosen")
      ->check(CLI::IsMember({"grid"}))
      ->capture_default_str();
  add_metric_option(command, a->metric);
  command.add_option("--epsilon", a->options.epsilon, "Largest error allowed")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  add_resolution_option(command, a->options.resolution);
  command.add_option("--seed", a->options.seed, "Random choices follow it")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command
      .add_option("--time-budget", a->options.time_budget,
                  "Seconds a mesh may take, then the best so far is kept; 0: no limit")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command.add_option("--threads", a->options.threads, "0: all cores")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command.add_option("--report", a->report, "Write a report as JSON");
  command.add_flag("--quiet", a->quiet, "Print nothing");
  command.callback([a] { run_simplify(*a); });
}

}  // namespace gradmesh
