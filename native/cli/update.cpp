#include <cstdio>

#include "app/document/document.h"
#include "app/document/svg_document.h"
#include "app/document/write_file.h"
#include "app/editing/edits.h"
#include "cli/commands.h"
#include "cli/common_options.h"

namespace gradmesh {
namespace {

struct UpdateArguments {
  std::filesystem::path in, out;
  std::vector<std::string> ids;
  bool quiet = false;
};

void run_update(const UpdateArguments& a) {
  const std::unique_ptr<Document> document = read_and_warn(a.in);
  const std::vector<UpdateReport> reports = update(*document, a.ids);
  write_file(*document, a.out);
  if (a.quiet) return;
  for (const auto& [id, counts, objects, changed] : reports)
    std::printf("%s: %d handles, %d patches, %d object%s, %s\n", id.c_str(), counts.handles,
                counts.patches, objects, objects == 1 ? "" : "s",
                changed ? "updated" : "not edited");
}

}  // namespace

void add_update(CLI::App& program) {
  const auto a = std::make_shared<UpdateArguments>();
  CLI::App& command = *program.add_subcommand(
      "update", "Make simplified meshes fit together again after their blocks were edited");
  add_path(command, "IN", a->in, "SVG document")->required();
  add_path(command, "-o,--output", a->out, "Where to write the document")->required();
  add_ids(command, a->ids);
  command.add_flag("--quiet", a->quiet, "Print nothing");
  command.callback([a] { run_update(*a); });
}

}  // namespace gradmesh
