#include "cli/commands.h"
#include "cli/common_options.h"
#include "cli/edit_output.h"

namespace gradmesh {
namespace {

struct RefineArguments {
  EditArguments edit;
  PatchChoice choice;
  RefineOptions options;
  std::string id, direction = "both";
  std::optional<int> row, column;
};

EditReport refine(Document& document, RefineArguments& a) {
  const auto line = [](const std::optional<int>& number) {
    return number ? std::optional(LineRange{*number, *number}) : std::nullopt;
  };
  if (!a.id.empty()) a.choice.ids = {a.id};
  a.choice.rows = line(a.row);
  a.choice.columns = line(a.column);
  a.options.rows = a.direction != "columns";
  a.options.columns = a.direction != "rows";
  return refine(document, a.choice, a.options, a.edit.measuring());
}

}  // namespace

void add_refine(CLI::App& program) {
  const auto a = std::make_shared<RefineArguments>();
  CLI::App& command =
      *program.add_subcommand("refine", "Split patches, so that detail can be added");
  add_edit_arguments(command, a->edit);
  command.add_option("--id", a->id,
                     "The patches of this block, or of this mesh if it is one rectangle; with "
                     "--patches the mesh");
  add_patches(command, a->choice.patches,
              "These patches, by numbers from draw --show faces, as in 3,4,7");
  command.add_option("--row", a->row, "Of a block or rectangular mesh only this row, from 1");
  command.add_option("--column", a->column, "Of these only this column, from 1");
  command
      .add_option("--direction", a->direction,
                  "rows: by a line from left to right. columns: from top to bottom")
      ->check(CLI::IsMember({"both", "rows", "columns"}))
      ->capture_default_str();
  command
      .add_option("--place", a->options.place,
                  "Where, from the top and from the left of each patch, above 0 and below 1")
      ->capture_default_str();
  command.add_flag("--whole", a->options.whole, "Let the lines go on across the whole mesh");
  command.callback([a] {
    run_edit(a->edit, [&](Document& document) { return std::vector{refine(document, *a)}; });
  });
}

}  // namespace gradmesh
