#include "cli/edit_output.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/document/mesh_source.h"
#include "app/document/write_file.h"
#include "app/export/info.h"
#include "app/export/mesh_picture.h"
#include "app/export/results_json.h"
#include "cli/common_options.h"
#include "files/image_file.h"

namespace gradmesh {
namespace {

void print_reports(const std::vector<EditReport>& reports, const EditArguments& a) {
  if (a.as_json) {
    nlohmann::ordered_json meshes = nlohmann::ordered_json::array();
    for (const EditReport& report : reports) meshes.push_back(edit_json(report));
    std::printf("%s\n", nlohmann::ordered_json{{"meshes", meshes}}.dump(2).c_str());
    return;
  }
  for (const auto& [id, before, after, objects, error] : reports)
    std::printf("%s: %d handles (%d before), %d patches (%d before), %d object%s, %s %.5f\n",
                id.c_str(), after.handles, before.handles, after.patches, before.patches, objects,
                objects == 1 ? "" : "s", label(a.measure.metric), error);
}

/// Paints the mesh as it was and as it would become. Throws InputError if several meshes were
/// edited, as a picture shows one.
void write_preview(const Document& document, const std::vector<EditReport>& reports,
                   const EditArguments& a) {
  std::vector<std::string> ids;
  for (const EditReport& report : reports) ids.push_back(report.id);
  const auto picture = [&](const Document& of, const MeshEntry& entry) {
    return picture_with_lines(of, entry, a.measure.resolution);
  };
  const Image after = picture(document, one_mesh(document, ids));
  const std::unique_ptr<Document> before = read_and_warn(a.in);
  write_png(beside(picture(*before, one_mesh(*before, ids)), after), a.preview);
}

}  // namespace

void add_edit_arguments(CLI::App& command, EditArguments& a) {
  add_path(command, "IN", a.in, any_document())->required();
  CLI::App& output = *command.add_option_group("Output")->require_option(1);
  add_path(output, "-o,--output", a.out, "Where to write the document");
  add_path(
      output, "--preview", a.preview,
      "Write no document, only a PNG image of the mesh as it is and, right of that, as it would "
      "become, with its lines");
  add_options(command, a.measure, {"metric", "resolution"});
  add_original_option(command, a.original);
  command.add_flag("--json", a.as_json, "Print JSON");
  command.add_flag("--quiet", a.quiet, "Print nothing");
}

void add_patches(CLI::App& command, std::vector<int>& patches, const std::string& help) {
  command.add_option("--patches", patches, help)->delimiter(',');
}

void run_edit(const EditArguments& a,
              const std::function<std::vector<EditReport>(Document&)>& edit) {
  const std::unique_ptr<Document> document = read_and_warn(a.in);
  const std::unique_ptr<Document> original = take_original(a.original, *document);
  const std::vector<EditReport> reports = edit(*document);
  if (a.preview.empty())
    write_file(*document, a.out);
  else
    write_preview(*document, reports, a);
  if (!a.quiet) print_reports(reports, a);
}

}  // namespace gradmesh
