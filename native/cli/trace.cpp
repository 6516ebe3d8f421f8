#include "app/pictures/trace.h"

#include <cstdio>

#include "app/document/write_file.h"
#include "app/export/results_json.h"
#include "app/runs/convert.h"
#include "base/utf8_path.h"
#include "cli/commands.h"
#include "cli/common_options.h"
#include "cli/progress_bar.h"
#include "files/atomic_file.h"

namespace gradmesh {
namespace {

struct TraceArguments {
  std::filesystem::path in, out, curve, report;
  /// FILE.svg#ID; empty for the whole picture.
  std::string outline;
  TraceOptions options;
  int resolution = usual_resolution;
  bool quiet = false;
};

std::string check_outline(const std::string& text) {
  const std::size_t at = text.rfind('#');
  const bool has_both = at != text.npos && at > 0 && at + 1 < text.size();
  return has_both ? "" : "a file and the id of a shape in it are needed: FILE.svg#ID";
}

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

/// Writes the document, or the mesh alone in the format that the path's extension names.
void write(const TracedDocument& traced, const std::filesystem::path& path) {
  const Document& document = *traced.document;
  const Format* format = format_of(path);
  if (!format || *format == document.format()) return write_file(document, path);
  write_file(
      *convert(document, document.selected({traced.tracing.id}).front(), *format, {}).document,
      path);
}

TracedDocument traced(const TraceArguments& a) {
  if (a.in.empty() && a.outline.empty()) throw CLI::RequiredError("PICTURE or --outline");
  if (a.outline.empty()) return trace_file(a.in, a.resolution, a.out.string(), a.options);
  const std::size_t at = a.outline.rfind('#');
  return trace_file_in_shape(a.in, a.resolution, utf8_path(a.outline.substr(0, at)),
                             a.outline.substr(at + 1), a.options);
}

void run_trace(TraceArguments& a) {
  TracedDocument made;
  {
    ProgressBar bar(a.quiet);
    a.options.progress = bar.callback();
    a.options.wants_curve = !a.curve.empty();
    made = traced(a);
  }
  if (!a.report.empty()) write_bytes(a.report, tracing_json(made.tracing).dump(2) + "\n");
  if (!a.curve.empty())
    write_bytes(a.curve, traced_curve_json(made.tracing.id, made.tracing.curve).dump(2) + "\n");
  if (!a.out.empty()) write(made, a.out);
  if (a.quiet) return;
  print_result(made.tracing, a.options.detail);
  if (const std::optional<Message> help = what_would_help(made.tracing))
    std::fprintf(stderr, "gradmesh: %s: %s\n", a.in.string().c_str(), help->english().c_str());
}

}  // namespace

void add_trace(CLI::App& program) {
  const auto a = std::make_shared<TraceArguments>();
  CLI::App& command =
      *program.add_subcommand("trace", "Make a gradient mesh that looks like a picture");
  add_path(
      command, "PICTURE", a->in,
      "A photograph or another picture: PNG, JPEG and more; with --outline that of its document");
  CLI::App& target = *command.add_option_group("Output")->require_option(1, 2);
  add_path(target, "-o,--output", a->out, "Where to write the document");
  add_path(target, "--curve", a->curve,
           "Take out line after line, and write handles and errors as JSON");
  CLI::Option* const outline = command
                                   .add_option("--outline", a->outline,
                                               "FILE.svg#ID: a shape on a picture, which becomes "
                                               "the mesh, or a picture; writes the whole document")
                                   ->check(check_outline);
  command
      .add_option("--guides", a->options.guides,
                  "Ids of open paths there, separated by commas, that lines of the mesh follow")
      ->delimiter(',')
      ->needs(outline);
  add_weigh_option(command, a->options.weights,
                   "Put lines first where this shape there is: what it covers counts so many "
                   "times, 0.25 to 4, as in eyes=4; may be repeated")
      ->needs(outline);
  command.add_option("--handles", a->options.handles, "At most that many points")
      ->check(CLI::Range(4, 100000))
      ->capture_default_str();
  CLI::Option* const epsilon = command
                                   .add_option("--epsilon", a->options.epsilon,
                                               "No more points than this error by FLIP needs")
                                   ->check(CLI::Range(0.0, 1.0))
                                   ->capture_default_str();
  const auto set_amount = [a](const std::string& name) {
    a->options.epsilon = amount_named(name).traced_epsilon;
  };
  command
      .add_option_function<std::string>("--amount", set_amount,
                                        "Instead of --epsilon: how much a person may see")
      ->check(CLI::IsMember(std::get<NamedValue>(option_named("amount").value).names()))
      ->excludes(epsilon);
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
