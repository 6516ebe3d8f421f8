#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>

#include "base/error.h"
#include "cli/progress_bar.h"
#include "cli/report.h"
#include "io/atomic_file.h"
#include "io/image_file.h"
#include "raster/rasterizer.h"

namespace gradmesh {
namespace {

void print_info(const std::string& in, bool as_json) {
  const nlohmann::ordered_json info = info_json(Document::read_file(in));
  if (as_json) {
    std::cout << info.dump(2) << "\n";
    return;
  }
  for (const auto& mesh : info["meshes"])
    std::printf("%s (%s): %d patches, %d points, %d T-junctions%s\n",
                mesh["id"].get<std::string>().c_str(), mesh["role"].get<std::string>().c_str(),
                mesh["patches"].get<int>(), mesh["points"].get<int>(),
                mesh["t_junctions"].get<int>(), mesh["simplified"] ? ", simplified" : "");
}

struct SimplifyArguments {
  std::string in, out, report, method = "grid", metric = "flip";
  std::vector<std::string> ids;
  SimplifyOptions options;
  bool quiet = false;
};

void run_simplify(SimplifyArguments& a) {
  a.options.method = method_named(a.method);
  a.options.metric = metric_named(a.metric);
  Document document = Document::read_file(a.in);
  std::vector<MeshReport> reports;
  {
    ProgressBar bar(a.quiet);
    a.options.progress = bar.callback();
    reports = document.simplify(a.ids, a.options);
  }
  // The report first: where it cannot be written the document is still as it was.
  if (!a.report.empty()) write_bytes(a.report, report_json(reports, a.options).dump(2) + "\n");
  document.write_file(a.out);
  if (a.quiet) return;
  for (const auto& [id, r] : reports)
    std::printf("%s: %d of %d patches left, %s %.5f, %.2f s (%s)\n", id.c_str(), r.patches_after,
                r.patches_before, a.options.metric == MetricKind::flip ? "FLIP" : "1 - SSIM",
                r.error, r.seconds.total, name(r.stopped));
}

void run_render(const std::string& in, const std::string& out, const std::string& id,
                int resolution, bool like_inkscape) {
  const Document document = Document::read_file(in);
  const auto objects =
      document.selected(id.empty() ? std::vector<std::string>{} : std::vector<std::string>{id});
  if (objects.size() > 1)
    throw InputError(in + ": there are " + std::to_string(objects.size()) +
                     " meshes, choose one with --id.");
  const auto rasterizer = like_inkscape ? make_cairo_like_rasterizer() : make_software_rasterizer();
  write_png(document.render(objects.front(), resolution, *rasterizer), out);
}

bool is_svg(const std::string& path) { return std::filesystem::path(path).extension() == ".svg"; }

/// The error between the only meshes of two documents, in the frame of the first.
double compare_meshes(const Document& a, const Document& b, MetricKind metric) {
  const auto from = a.selected({}), to = b.selected({});
  if (from.size() != 1 || to.size() != 1)
    throw InputError(a.name() + " and " + b.name() + " must hold one mesh each to be compared.");
  const Mesh first = a.mesh(from.front()), second = b.mesh(to.front());
  const Frame frame = fit_frame(first, to_document(from.front()), 700);
  Frame other = frame;
  other.to_pixels = frame.to_pixels * to_document(from.front()).inverse() * to_document(to.front());
  const auto rasterizer = make_software_rasterizer();
  return mean(
      make_metric(metric, rasterizer->paint(first, frame))->map(rasterizer->paint(second, other)));
}

void run_compare(const std::string& a, const std::string& b, MetricKind metric) {
  double error = 0;
  if (is_svg(a) && is_svg(b)) {
    error = compare_meshes(Document::read_file(a), Document::read_file(b), metric);
  } else {
    const Image first = read_image(a), second = read_image(b);
    if (first.width != second.width || first.height != second.height)
      throw InputError(a + " and " + b + " are not of one size.");
    error = mean(make_metric(metric, first)->map(second));
  }
  std::printf("%.6f\n", error);
}

int run(int argc, char** argv) {
  CLI::App app("Takes needless patches out of gradient meshes, without visible change.",
               "gradmesh");
  app.set_version_flag("--version", GRADMESH_VERSION);
  app.require_subcommand(1);

  std::string in, out, other, id, metric = "flip";
  bool as_json = false, like_inkscape = false;
  int resolution = 700;

  CLI::App* info = app.add_subcommand("info", "List the meshes of a document");
  info->add_option("IN", in, "SVG document")->required();
  info->add_flag("--json", as_json, "Print JSON");
  info->callback([&] { print_info(in, as_json); });

  SimplifyArguments s;
  CLI::App* simplify = app.add_subcommand("simplify", "Merge patches while the error allows it");
  simplify->add_option("IN", s.in, "SVG document")->required();
  simplify->add_option("-o,--output", s.out, "Where to write the document")->required();
  simplify->add_option("--id", s.ids, "Only this object, or all meshes inside it; may be repeated")
      ->take_all()
      ->expected(1);
  simplify->add_option("--method", s.method, "How edges are chosen")
      ->check(CLI::IsMember({"grid"}))
      ->capture_default_str();
  simplify->add_option("--metric", s.metric, "How pictures are compared")
      ->check(CLI::IsMember({"flip", "ssim"}))
      ->capture_default_str();
  simplify->add_option("--epsilon", s.options.epsilon, "Largest error allowed")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  simplify->add_option("--resolution", s.options.resolution, "Pixels along the longer side")
      ->check(CLI::Range(16, 8192))
      ->capture_default_str();
  simplify->add_option("--seed", s.options.seed, "Random choices follow it")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  simplify
      ->add_option("--time-budget", s.options.time_budget,
                   "Seconds a mesh may take, then the best so far is kept; 0: no limit")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  simplify->add_option("--threads", s.options.threads, "0: all cores")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  simplify->add_option("--report", s.report, "Write a report as JSON");
  simplify->add_flag("--quiet", s.quiet, "Print nothing");
  simplify->callback([&] { run_simplify(s); });

  CLI::App* render = app.add_subcommand("render", "Paint a mesh to a PNG image");
  render->add_option("IN", in, "SVG document")->required();
  render->add_option("-o,--output", out, "PNG image")->required();
  render->add_option("--id", id, "Which mesh, where there are several");
  render->add_option("--resolution", resolution, "Pixels along the longer side")
      ->check(CLI::Range(16, 8192))
      ->capture_default_str();
  render->add_flag("--like-inkscape", like_inkscape,
                   "Take Inkscape's point of each pixel instead of the centre");
  render->callback([&] { run_render(in, out, id, resolution, like_inkscape); });

  CLI::App* compare = app.add_subcommand(
      "compare",
      "Print the error between two images of one size, or two documents of one mesh each");
  compare->add_option("A", in, "Image or SVG document; the reference")->required();
  compare->add_option("B", other, "Image or SVG document")->required();
  compare->add_option("--metric", metric, "How pictures are compared")
      ->check(CLI::IsMember({"flip", "ssim"}))
      ->capture_default_str();
  compare->callback([&] { run_compare(in, other, metric_named(metric)); });

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::invalid_argument& error) {
    std::cerr << "gradmesh: " << error.what() << "\n";
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "gradmesh: " << error.what() << "\n";
    return 1;
  }
  return 0;
}

}  // namespace
}  // namespace gradmesh

int main(int argc, char** argv) { return gradmesh::run(argc, argv); }
