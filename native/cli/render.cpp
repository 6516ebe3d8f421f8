#include "cli/commands.h"
#include "cli/common_options.h"
#include "cli/one_mesh.h"
#include "io/image_file.h"

namespace gradmesh {
namespace {

struct RenderArguments {
  std::string in, out, id;
  int resolution = 700;
  bool like_inkscape = false;
};

void run_render(const RenderArguments& a) {
  const std::unique_ptr<Document> document = Document::read_file(a.in);
  const MeshEntry entry = one_mesh(*document, a.id);
  write_png(a.like_inkscape ? document->render_like_inkscape(entry, a.resolution)
                            : document->render(entry, a.resolution, *make_software_rasterizer()),
            a.out);
}

}  // namespace

void add_render(CLI::App& program) {
  const auto a = std::make_shared<RenderArguments>();
  CLI::App& command = *program.add_subcommand("render", "Paint a mesh to a PNG image");
  command.add_option("IN", a->in, "SVG document or .hemesh file")->required();
  command.add_option("-o,--output", a->out, "PNG image")->required();
  command.add_option("--id", a->id, "Which mesh, where there are several");
  add_resolution_option(command, a->resolution);
  command.add_flag("--like-inkscape", a->like_inkscape,
                   "Take Inkscape's point of each pixel instead of the centre");
  command.callback([a] { run_render(*a); });
}

}  // namespace gradmesh
