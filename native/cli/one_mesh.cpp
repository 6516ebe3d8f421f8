#include "app/editing/to_one_mesh.h"
#include "cli/commands.h"
#include "cli/common_options.h"
#include "cli/edit_output.h"

namespace gradmesh {
namespace {

struct OneMeshArguments {
  EditArguments edit;
  std::vector<std::string> ids;
};

}  // namespace

void add_one_mesh(CLI::App& program) {
  const auto a = std::make_shared<OneMeshArguments>();
  CLI::App& command = *program.add_subcommand(
      "one-mesh", "Make ordinary meshes of simplified ones, without T-junctions");
  add_edit_arguments(command, a->edit);
  add_ids(command, a->ids);
  command.callback([a] {
    run_edit(a->edit, [&](Document& document) {
      return to_one_mesh(document, a->ids, a->edit.measuring());
    });
  });
}

}  // namespace gradmesh
