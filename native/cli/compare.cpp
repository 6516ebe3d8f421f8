#include <cstdio>

#include "base/error.h"
#include "cli/commands.h"
#include "cli/common_options.h"
#include "document/document.h"
#include "io/image_file.h"
#include "raster/rasterizer.h"

namespace gradmesh {
namespace {

struct CompareArguments {
  std::string a, b, metric = "flip";
};

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

double compare_images(const std::string& a, const std::string& b, MetricKind metric) {
  const Image first = read_image(a), second = read_image(b);
  if (first.width != second.width || first.height != second.height)
    throw InputError(a + " and " + b + " are not of one size.");
  return mean(make_metric(metric, first)->map(second));
}

void run_compare(const CompareArguments& args) {
  const MetricKind metric = metric_named(args.metric);
  const double error =
      is_svg(args.a) && is_svg(args.b)
          ? compare_meshes(Document::read_file(args.a), Document::read_file(args.b), metric)
          : compare_images(args.a, args.b, metric);
  std::printf("%.6f\n", error);
}

}  // namespace

void add_compare(CLI::App& program) {
  const auto a = std::make_shared<CompareArguments>();
  CLI::App& command = *program.add_subcommand(
      "compare",
      "Print the error between two images of one size, or two documents of one mesh each");
  command.add_option("A", a->a, "Image or SVG document; the reference")->required();
  command.add_option("B", a->b, "Image or SVG document")->required();
  add_metric_option(command, a->metric);
  command.callback([a] { run_compare(*a); });
}

}  // namespace gradmesh
