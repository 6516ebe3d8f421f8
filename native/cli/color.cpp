#include "formats/svg/values/color.h"
#include "cli/commands.h"
#include "cli/common_options.h"
#include "cli/edit_output.h"

namespace gradmesh {
namespace {

struct ColorArguments {
  EditArguments edit;
  PointChoice choice;
  std::optional<glm::dvec3> color;
  bool joins = false;
};

}  // namespace

void add_color(CLI::App& program) {
  const auto a = std::make_shared<ColorArguments>();
  CLI::App& command = *program.add_subcommand(
      "color", "Set the colour at points, for all patches around them or sharply for some");
  add_edit_arguments(command, a->edit);
  add_id(command, a->choice.id);
  command
      .add_option("--points", a->choice.points,
                  "The numbers of the points, from draw --show edges, as in 3,4,7")
      ->delimiter(',')
      ->required();
  CLI::App& what = *command.add_option_group("What")->require_option(1);
  what.add_option_function<std::string>(
      "--color",
      [a](const std::string& text) {
        a->color = parse_color(text);
        if (!a->color) throw CLI::ValidationError("--color", "'" + text + "' is no colour of SVG");
      },
      "The colour, as SVG writes it, such as #rrggbb or a name");
  what.add_flag("--join", a->joins,
                "Give all patches at a point one colour again, the mean of theirs");
  add_patches(command, a->choice.patches,
              "For these patches alone, by numbers from draw --show faces, as in 3,4");
  command.get_option("--patches")->excludes(what.get_option("--join"));
  command.callback([a] {
    run_edit(a->edit, [&](Document& document) {
      const MeasureOptions measure = a->edit.measuring();
      return std::vector{a->joins ? join_colors(document, a->choice, measure)
                                  : recolor(document, a->choice, *a->color, measure)};
    });
  });
}

}  // namespace gradmesh
