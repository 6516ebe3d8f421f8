#include "app/trace.h"

#include <cstdio>

#include "app/convert.h"
#include "cli/commands.h"
#include "cli/common_options.h"
#include "cli/progress_bar.h"
#include "files/atomic_file.h"

namespace gradmesh {
namespace {

struct TraceArguments {
  std::filesystem::path in, out, report;
  TraceOptions options;
  int resolution = usual_resolution;
  bool quiet = false;
};

void print_result(const Tracing& traced, double detail) {
  const auto print_errors = [](const char* against, const PictureErrors& e) {
    std::printf("against the picture%s: FLIP %.4f, mean difference %.2f and RMSE %.2f of 255\n",
                against, e.flip, e.mean, e.rmse);
  };
  std::printf("%d handles, %d x %d patches, %.2f s%s\n", traced.counts.handles, traced.rows,
              traced.columns, traced.seconds, traced.was_stopped ? " (stopped early)" : "");
  print_errors("", traced.errors);
  if (detail > 1) print_errors(" without detail", traced.errors_without_detail);
}

/// Writes the mesh in the format that the path's extension names.
void write(const Document& document, const std::filesystem::path& path) {
  const Format* format = format_of(path);
  if (!format || *format == document.format()) return document.write_file(path);
  convert(document, document.meshes().front(), *format, {}).document->write_file(path);
}

void run_trace(TraceArguments& a) {
  Tracing traced;
  {
    ProgressBar bar(a.quiet);
    a.options.progress = bar.callback();
    traced = trace_file(a.in, a.resolution, a.out.string(), a.options);
  }
  if (!a.report.empty()) write_bytes(a.report, tracing_json(traced).dump(2) + "\n");
  write(*traced.document, a.out);
  if (a.quiet) return;
  print_result(traced, a.options.detail);
  if (const std::optional<Message> help = what_would_help(traced))
    std::fprintf(stderr, "gradmesh: %s: %s\n", a.in.string().c_str(), help->english().c_str());
}

}  // namespace

void add_trace(CLI::App& program) {
  const auto a = std::make_shared<TraceArguments>();
  CLI::App& command =
      *program.add_subcommand("trace", "Make a gradient mesh that looks like a picture");
  add_path(command, "PICTURE", a->in, "A photograph or another picture: PNG, JPEG and more")
      ->required();
  add_path(command, "-o,--output", a->out, "Where to write the document")->required();
  command.add_option("--handles", a->options.handles, "At most that many points")
      ->check(CLI::Range(4, 100000))
      ->capture_default_str();
  command
      .add_option("--epsilon", a->options.epsilon, "No more points than this error by FLIP needs")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  command
      .add_option("--detail", a->options.detail,
                  "Follow nothing smaller, in pixels of the picture: noise and texture")
      ->check(CLI::Range(1.0, 100000.0))
      ->capture_default_str();
  command
      .add_option("--resolution", a->resolution,
                  "Compare at that many pixels along the longer side")
      ->check(CLI::Range(least_resolution, 16384))
      ->capture_default_str();
  command
      .add_option("--time-budget", a->options.time_budget,
                  "Take the best mesh after that many seconds; 0 for no limit")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command.add_option("--threads", a->options.threads, "Number of threads; 0 for all cores")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  add_path(command, "--report", a->report, "Write a report as JSON");
  command.add_flag("--quiet", a->quiet, "Print nothing");
  command.callback([a] { run_trace(*a); });
}

}  // namespace gradmesh
