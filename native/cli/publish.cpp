#include "app/publish.h"

#include <cstdio>
#include <filesystem>

#include "cli/commands.h"
#include "cli/common_options.h"

namespace gradmesh {
namespace {

struct PublishArguments {
  PageChoice pages;
  std::filesystem::path in, out;
  PublishOptions options;
  bool quiet = false;
};

void print(const PublishedMesh& mesh) {
  if (mesh.as == PublishedAs::picture)
    std::printf("%s: %s, %d x %d pixels, %zu bytes\n", mesh.id.c_str(), name(mesh.as), mesh.width,
                mesh.height, mesh.bytes);
  else
    std::printf("%s: %s\n", mesh.id.c_str(), name(mesh.as));
}

void run_publish(const PublishArguments& a) {
  const std::unique_ptr<Document> document = read_document(a.in, a.pages);
  document->check_target(a.out);
  const std::vector<PublishedMesh> meshes = publish(*document, a.options);
  document->write_file(a.out);
  for (const PublishedMesh& mesh : meshes) {
    if (mesh.refused)
      std::fprintf(stderr, "gradmesh: left as it was: %s\n", mesh.refused->english().c_str());
    else if (!a.quiet)
      print(mesh);
  }
  if (!a.quiet)
    std::printf("%s: %zu bytes\n", a.out.string().c_str(),
                std::size_t(std::filesystem::file_size(a.out)));
}

}  // namespace

void add_publish(CLI::App& program) {
  const auto a = std::make_shared<PublishArguments>();
  CLI::App& command = *program.add_subcommand(
      "publish", "Make a copy for programs without mesh gradients, such as browsers");
  add_path(command, "IN", a->in, "SVG document or PDF")->required();
  add_path(command, "-o,--output", a->out, "Where to write the copy")->required();
  add_page_options(command, a->pages);
  command
      .add_option("--scale", a->options.scale,
                  "Most pixels of the pictures for each pixel of the document")
      ->check(CLI::Range(0.01, 16.0))
      ->capture_default_str();
  command.add_flag("--quiet", a->quiet, "Print nothing");
  command.callback([a] { run_publish(*a); });
}

}  // namespace gradmesh
