#include "app/runs/convert.h"

#include <cstdio>

#include "app/document/mesh_source.h"
#include "app/document/write_file.h"
#include "cli/commands.h"
#include "cli/common_options.h"

namespace gradmesh {
namespace {

struct ConvertArguments {
  std::filesystem::path in, out;
  PageChoice pages;
  std::string id;
  SimplifyOptions measure;
  ConvertOptions options;
};

void run_convert(ConvertArguments& a) {
  const Format* format = format_of(a.out);
  if (!format)
    throw std::invalid_argument(a.out.string() + " must end in " +
                                formats_in_words(&Format::extension) + ".");
  a.options.metric = a.measure.metric;
  a.options.resolution = a.measure.resolution;
  const std::unique_ptr<Document> from = read_and_warn(a.in, a.pages);
  if (from->pages() && *format == from->format() && a.id.empty()) {
    write_file(*from, a.out);
    for (const MeshEntry& entry : from->meshes())
      std::printf("%s: %d patches\n", entry.id.c_str(), from->mesh(entry).face_count());
    return;
  }
  const MeshEntry entry = one_mesh(*from, a.id);
  const Conversion to = convert(*from, entry, *format, a.options);
  write_file(*to.document, a.out);
  std::printf("%s: %d patches, %s %.5f%s\n", entry.id.c_str(),
              to.document->mesh(to.document->meshes().front()).face_count(),
              label(a.options.metric), to.error,
              to.lost_opacity
                  ? ("; its opacity is lost, which " + format->label + " cannot hold").c_str()
                  : "");
}

}  // namespace

void add_convert(CLI::App& program) {
  const auto a = std::make_shared<ConvertArguments>();
  CLI::App& command = *program.add_subcommand(
      "convert",
      "Turn a .hemesh file or a PDF into an SVG document, or any of these into a .hemesh file");
  add_path(command, "IN", a->in, any_document())->required();
  add_path(command, "OUT", a->out,
           "Its extension, " + formats_in_words(&Format::extension) + ", says what it becomes")
      ->required();
  add_page_options(command, a->pages);
  add_id(command, a->id);
  CLI::Option* subdivide =
      command.add_option("--subdivide", a->options.subdivide, "Split every patch into N x N")
          ->check(CLI::Range(1, 32));
  command
      .add_option("--epsilon", a->options.epsilon,
                  "Into SVG: split patches until the error is at most this")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str()
      ->excludes(subdivide);
  add_options(command, a->measure, {"metric", "resolution"});
  command.callback([a, &command] {
    a->options.must_keep_epsilon = command.count("--epsilon") > 0;
    run_convert(*a);
  });
}

}  // namespace gradmesh
