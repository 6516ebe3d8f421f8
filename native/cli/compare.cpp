#include <cstdio>

#include "base/error.h"
#include "cli/commands.h"
#include "cli/common_options.h"
#include "document/document.h"
#include "io/image_file.h"
#include "mesh/boundary.h"
#include "raster/rasterizer.h"

namespace gradmesh {
namespace {

struct CompareArguments {
  std::string a, b, metric = "flip";
};

/// The only mesh of a document.
struct OnlyMesh {
  explicit OnlyMesh(const std::string& path) : document(Document::read_file(path)) {
    const auto found = document->selected({});
    if (found.size() > 1)
      throw InputError(path + ": there are " + std::to_string(found.size()) +
                       " meshes, but a document to be compared must hold one.");
    entry = found.front();
    mesh = document->mesh(entry);
  }

  Affine view() const { return document->view(entry); }
  Image paint_like(const Image& other) const {
    return document->render(entry, std::max(other.width, other.height),
                            *make_software_rasterizer());
  }

  std::unique_ptr<Document> document;
  MeshEntry entry;
  Mesh mesh;
};

using Pair = std::pair<Image, Image>;

/// Takes the second mesh to where the first one is, as both are seen: the same box, whose longer
/// sides agree.
Affine aligned(const OnlyMesh& a, const OnlyMesh& b) {
  const Box to = bounding_box(a.mesh, a.view()), from = bounding_box(b.mesh, b.view());
  const double scale = std::max(to.size().x, to.size().y) / std::max(from.size().x, from.size().y);
  return Affine::translation(to.low()) * Affine::scaling(glm::dvec2(scale)) *
         Affine::translation(-from.low());
}

/// Two documents of one kind share their coordinates. Where the kinds differ, one mesh is laid on
/// the other.
Pair paint_both(const OnlyMesh& a, const OnlyMesh& b) {
  constexpr int resolution = 700;
  const bool same_kind = a.document->kind() == b.document->kind();
  const Frame first = same_kind ? a.document->frame(a.entry, a.mesh, resolution)
                                : fit_frame(a.mesh, a.view(), resolution);
  Frame second = first;
  const Affine onto_first = same_kind ? b.view() : aligned(a, b) * b.view();
  second.to_pixels = first.to_pixels * a.view().inverse() * onto_first;
  const auto rasterizer = make_software_rasterizer();
  return {rasterizer->paint(a.mesh, first), rasterizer->paint(b.mesh, second)};
}

/// A document beside an image is painted as large as the image.
Pair pictures(const std::string& a, const std::string& b) {
  if (kind_of(a) && kind_of(b)) return paint_both(OnlyMesh(a), OnlyMesh(b));
  if (kind_of(a)) {
    const Image second = read_image(b);
    return {OnlyMesh(a).paint_like(second), second};
  }
  const Image first = read_image(a);
  return {first, kind_of(b) ? OnlyMesh(b).paint_like(first) : read_image(b)};
}

void run_compare(const CompareArguments& args) {
  const auto [first, second] = pictures(args.a, args.b);
  if (first.width != second.width || first.height != second.height)
    throw InputError(args.a + " and " + args.b + " are not of one size.");
  std::printf("%.6f\n", mean(make_metric(metric_named(args.metric), first)->map(second)));
}

}  // namespace

void add_compare(CLI::App& program) {
  const auto a = std::make_shared<CompareArguments>();
  CLI::App& command = *program.add_subcommand(
      "compare",
      "Print the error between two pictures: images of one size, or documents of one mesh each");
  command.add_option("A", a->a, "Image, SVG document or .hemesh file; the reference")->required();
  command.add_option("B", a->b, "Image, SVG document or .hemesh file")->required();
  add_metric_option(command, a->metric);
  command.callback([a] { run_compare(*a); });
}

}  // namespace gradmesh
