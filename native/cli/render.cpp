#include "app/document/mesh_source.h"
#include "app/export/mesh_picture.h"
#include "app/runs/devices.h"
#include "cli/commands.h"
#include "cli/common_options.h"
#include "device/egl_rasterizer.h"
#include "files/image_file.h"

namespace gradmesh {
namespace {

struct RenderArguments {
  std::filesystem::path in, out, framed_as;
  std::string id;
  RunOptions options;
  std::string renderer = name(Renderer::automatic);
  bool like_inkscape = false;
};

/// Paints the picture. Uses a device only if it was asked for, as one picture is not worth starting
/// it.
Image paint(const Document& document, const MeshEntry& entry, const RenderArguments& a,
            const Document* other) {
  RunOptions options = a.options;
  if (a.renderer == name(Renderer::egl)) take_renderer(a.renderer, options);
  try {
    if (options.device)
      return render(document, entry, a.options.resolution, *make_egl_rasterizer(options.device),
                    other);
  } catch (const DeviceError& error) {
    say_without_device(error.what());
  }
  return render(document, entry, a.options.resolution, *make_software_rasterizer(), other);
}

void run_render(const RenderArguments& a) {
  const std::unique_ptr<Document> document = read_and_warn(a.in);
  const MeshEntry entry = one_mesh(*document, a.id);
  std::unique_ptr<Document> other;
  if (!a.framed_as.empty()) other = read_and_warn(a.framed_as);
  write_png(a.like_inkscape
                ? render_like_inkscape(*document, entry, a.options.resolution, other.get())
                : paint(*document, entry, a, other.get()),
            a.out);
}

}  // namespace

void add_render(CLI::App& program) {
  const auto a = std::make_shared<RenderArguments>();
  CLI::App& command = *program.add_subcommand("render", "Paint a mesh to a PNG image");
  add_path(command, "IN", a->in, any_document())->required();
  add_path(command, "-o,--output", a->out, "PNG image")->required();
  add_id(command, a->id);
  add_path(command, "--framed-as", a->framed_as,
           "Paint it where this document's mesh would be, of the same id or the only one");
  add_options(command, a->options, {"resolution"});
  add_renderer_option(command, a->renderer);
  command.add_flag("--like-inkscape", a->like_inkscape,
                   "Take Inkscape's point of each pixel instead of the centre");
  command.callback([a] { run_render(*a); });
}

}  // namespace gradmesh
