#include "app/export/publish.h"

#include <cstdio>
#include <filesystem>

#include "app/document/write_file.h"
#include "app/export/publish_code.h"
#include "base/utf8_path.h"
#include "cli/commands.h"
#include "cli/common_options.h"
#include "files/atomic_file.h"

namespace gradmesh {
namespace {

struct PublishArguments {
  PageChoice pages;
  std::filesystem::path in, out;
  std::string as = "svg";
  PublishOptions options;
  CLI::Option* scale = nullptr;
  bool quiet = false;
};

void print(const PublishedMesh& mesh) {
  if (mesh.as == PublishedAs::picture)
    std::printf("%s: %s, %d x %d pixels, %zu bytes\n", mesh.id.c_str(), name(mesh.as), mesh.width,
                mesh.height, mesh.bytes);
  else
    std::printf("%s: %s\n", mesh.id.c_str(), name(mesh.as));
}

void say_left_alone(const Message& refusal) {
  std::fprintf(stderr, "gradmesh: left as it was: %s\n", refusal.english().c_str());
}

void publish_svg(const PublishArguments& a) {
  const std::unique_ptr<Document> document = read_and_warn(a.in, a.pages);
  check_target(*document, a.out);
  const std::vector<PublishedMesh> meshes = publish(*document, a.options);
  write_file(*document, a.out);
  for (const PublishedMesh& mesh : meshes) {
    if (mesh.refused)
      say_left_alone(*mesh.refused);
    else if (!a.quiet)
      print(mesh);
  }
  if (!a.quiet)
    std::printf("%s: %zu bytes\n", a.out.string().c_str(),
                std::size_t(std::filesystem::file_size(a.out)));
}

/// Returns true if the path names a file of code, false if a folder. Throws InputError if it names
/// a file of another kind.
bool is_code_file(const std::filesystem::path& out, const std::string& extension) {
  if (std::filesystem::is_directory(out)) return false;
  if (out.extension() == extension) return true;
  if (out.has_extension() || std::filesystem::exists(out))
    throw InputError("{0}: the code is written into a file {1} or into a folder.", out.string(),
                     "*" + extension);
  return false;
}

/// Returns the files into which meshes are written, one each. Throws InputError if one is there
/// that gradmesh has not written.
std::vector<std::filesystem::path> code_files(const std::filesystem::path& folder,
                                              const std::vector<PublishedCode>& meshes,
                                              const std::string& extension) {
  std::vector<std::filesystem::path> files;
  for (const PublishedCode& mesh : meshes) {
    const auto& file = files.emplace_back(folder / utf8_path(mesh.name + extension));
    if (std::filesystem::exists(file) && !is_published_code(read_bytes(file)))
      throw InputError("{0} is there already, and is not of gradmesh: choose another folder.",
                       file.string());
  }
  return files;
}

void write_code(const std::filesystem::path& path, const std::string& name,
                const std::string& source, bool quiet) {
  write_bytes(path, source);
  if (!quiet) std::printf("%s%s: %zu bytes\n", name.c_str(), path.string().c_str(), source.size());
}

void publish_sources(const PublishArguments& a) {
  if (*a.scale) throw std::invalid_argument("--scale goes with --as svg only.");
  const CodeLanguage language = code_language_named(a.as);
  const std::string extension = code_extension(language);
  const bool is_file = is_code_file(a.out, extension);
  const std::unique_ptr<Document> document = read_and_warn(a.in, a.pages);
  PublishedSources published = publish_code(*document, language);
  for (const PublishedCode& mesh : published.meshes) {
    if (mesh.refused) say_left_alone(*mesh.refused);
    for (const Message& sentence : mesh.lost)
      std::fprintf(stderr, "gradmesh: %s\n", sentence.english().c_str());
  }
  std::vector<PublishedCode>& meshes = published.meshes;
  std::erase_if(meshes, [](const PublishedCode& mesh) { return mesh.refused.has_value(); });
  if (is_file) {
    for (const PublishedCode& mesh : meshes)
      if (!a.quiet) std::printf("%s: %s\n", mesh.id.c_str(), mesh.name.c_str());
    return write_code(a.out, "", published.source, a.quiet);
  }
  const std::vector<std::filesystem::path> files = code_files(a.out, meshes, extension);
  std::error_code failed;
  std::filesystem::create_directories(a.out, failed);
  if (failed) throw InputError("{0}: the folder cannot be made.", a.out.string());
  for (std::size_t i = 0; i < files.size(); ++i)
    write_code(files[i], meshes[i].id + ": " + meshes[i].name + ", ", meshes[i].source, a.quiet);
}

void run_publish(const PublishArguments& a) {
  if (a.as == "svg")
    publish_svg(a);
  else
    publish_sources(a);
}

}  // namespace

void add_publish(CLI::App& program) {
  const auto a = std::make_shared<PublishArguments>();
  CLI::App& command = *program.add_subcommand(
      "publish", "Make a copy for programs without mesh gradients, or code of the meshes for apps");
  add_path(command, "IN", a->in, "SVG document or PDF")->required();
  add_path(command, "-o,--output", a->out,
           "Where to write the copy or, for apps, one file of code or a folder for a file each")
      ->required();
  add_page_options(command, a->pages);
  command
      .add_option("--as", a->as,
                  "svg: a copy with meshes as pictures. swift: views of SwiftUI. compose: "
                  "composables of Jetpack Compose, in Kotlin")
      ->check(CLI::IsMember({"svg", "swift", "compose"}))
      ->capture_default_str();
  a->scale = command
                 .add_option("--scale", a->options.scale,
                             "Most pixels of the pictures for each pixel of the document")
                 ->check(CLI::Range(0.01, 16.0))
                 ->capture_default_str();
  command.add_flag("--quiet", a->quiet, "Print nothing");
  command.callback([a] { run_publish(*a); });
}

}  // namespace gradmesh
