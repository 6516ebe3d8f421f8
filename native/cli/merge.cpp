#include "cli/commands.h"
#include "cli/common_options.h"
#include "cli/edit_output.h"

namespace gradmesh {
namespace {

struct MergeArguments {
  EditArguments edit;
  PatchChoice choice;
};

/// Adds an option for rows or columns: one, or the first and the last, as in 2 or 2-3.
void add_lines(CLI::App& command, const std::string& flag, std::optional<LineRange>& lines) {
  const auto take = [&lines, flag](const std::string& text) {
    const std::size_t dash = text.find('-', 1);
    LineRange range;
    const bool is_range =
        CLI::detail::lexical_cast(text.substr(0, dash), range.first) &&
        CLI::detail::lexical_cast(dash == text.npos ? text : text.substr(dash + 1), range.last);
    if (!is_range) throw CLI::ValidationError(flag, "must be a number, or two as in 2-3");
    lines = range;
  };
  command.add_option_function<std::string>(
      flag, take, "Of one block or rectangular mesh only these, from 1, as in 2 or 2-3");
}

}  // namespace

void add_merge(CLI::App& program) {
  const auto a = std::make_shared<MergeArguments>();
  CLI::App& command = *program.add_subcommand("merge", "Make one patch of several");
  add_edit_arguments(command, a->edit);
  command
      .add_option("--id", a->choice.ids,
                  "The patches of this block, or of this mesh if it is one rectangle; with "
                  "--patches the mesh; may be repeated")
      ->take_all()
      ->expected(1);
  add_patches(command, a->choice.patches,
              "These patches, by numbers from draw --show faces, as in 3,4,7");
  add_lines(command, "--rows", a->choice.rows);
  add_lines(command, "--columns", a->choice.columns);
  command.callback([a] {
    run_edit(a->edit, [&](Document& document) {
      return std::vector{merge(document, a->choice, a->edit.measuring())};
    });
  });
}

}  // namespace gradmesh
