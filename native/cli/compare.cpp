#include <cstdio>

#include "app/document/frames.h"
#include "app/export/mesh_picture.h"
#include "base/error.h"
#include "cli/commands.h"
#include "cli/common_options.h"
#include "files/image_file.h"
#include "raster/rasterizer.h"

namespace gradmesh {
namespace {

struct CompareArguments {
  std::filesystem::path a, b;
  SimplifyOptions options;
};

/// The only mesh of a document.
struct OnlyMesh {
  explicit OnlyMesh(const std::filesystem::path& path) : document(read_and_warn(path)) {
    const auto found = document->selected({});
    if (found.size() > 1)
      throw InputError("{0}: there are {1} meshes, but a document to be compared must hold one.",
                       path.string(), found.size());
    seen = {document.get(), found.front(), document->mesh(found.front())};
  }

  Image paint_like(const Image& other) const {
    return render(*document, seen.entry, std::max(other.width, other.height),
                  *make_software_rasterizer());
  }

  std::unique_ptr<Document> document;
  MeshInDocument seen;
};

using Pair = std::pair<Image, Image>;

Pair paint_both(const OnlyMesh& a, const OnlyMesh& b, int resolution) {
  const auto [first, second] = common_frames(a.seen, b.seen, resolution);
  const auto rasterizer = make_software_rasterizer();
  return {rasterizer->paint(a.seen.mesh, first), rasterizer->paint(b.seen.mesh, second)};
}

bool is_document(const std::filesystem::path& path) { return format_of(path) || is_of_pages(path); }

/// Returns the two pictures. A document beside an image is painted as large as the image.
Pair pictures(const std::filesystem::path& a, const std::filesystem::path& b, int resolution) {
  if (is_document(a) && is_document(b)) return paint_both(OnlyMesh(a), OnlyMesh(b), resolution);
  if (is_document(a)) {
    const Image second = read_image(b);
    return {OnlyMesh(a).paint_like(second), second};
  }
  const Image first = read_image(a);
  return {first, is_document(b) ? OnlyMesh(b).paint_like(first) : read_image(b)};
}

void run_compare(const CompareArguments& args) {
  const auto [first, second] = pictures(args.a, args.b, args.options.resolution);
  if (first.width != second.width || first.height != second.height)
    throw InputError("{0} and {1} are not of one size.", args.a.string(), args.b.string());
  std::printf("%.6f\n", mean(make_metric(args.options.metric, first)->map(second)));
}

}  // namespace

void add_compare(CLI::App& program) {
  const auto a = std::make_shared<CompareArguments>();
  CLI::App& command = *program.add_subcommand(
      "compare",
      "Print the error between two pictures: images of one size, or documents of one mesh each");
  add_path(command, "A", a->a, "Image, " + any_document() + "; the reference")->required();
  add_path(command, "B", a->b, "Image, " + any_document())->required();
  add_options(command, a->options, {"metric", "resolution"});
  command.callback([a] { run_compare(*a); });
}

}  // namespace gradmesh
