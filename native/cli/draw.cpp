#include "app/document/mesh_source.h"
#include "app/export/draw_document.h"
#include "cli/commands.h"
#include "cli/common_options.h"
#include "cli/progress_bar.h"
#include "files/atomic_file.h"

namespace gradmesh {
namespace {

struct DrawArguments {
  std::filesystem::path in, out;
  std::string id, show, region;
  DrawOptions options;
  PricePaths analyses;
  bool no_picture = false, quiet = false;
};

/// Returns what is wrong with the value of --region; empty if nothing is.
std::string region_problem(const std::string& text) {
  int number = 0;
  if (text == "all" || (CLI::detail::lexical_cast(text, number) && number > 0)) return "";
  return "must be a whole number from 1, or all";
}

void run_draw(DrawArguments& a) {
  if (a.show != "regions" && (a.options.patch || !a.region.empty()))
    throw std::invalid_argument("--patch and --region go with --show regions only.");
  a.options.show = show_named(a.show);
  a.options.picture = !a.no_picture;
  if (!a.region.empty()) a.options.region = a.region == "all" ? 0 : std::stoi(a.region);
  const std::unique_ptr<Document> document = read_and_warn(a.in);
  std::string text;
  {
    ProgressBar bar(a.quiet || a.options.show == Show::edges || a.options.show == Show::faces);
    a.options.simplify.progress = bar.callback();
    text = draw(*document, one_mesh(*document, a.id), a.options, a.analyses);
  }
  write_bytes(a.out, text);
}

}  // namespace

void add_draw(CLI::App& program) {
  const auto a = std::make_shared<DrawArguments>();
  CLI::App& command = *program.add_subcommand("draw", "Draw a mesh and what is known about it");
  add_path(command, "IN", a->in, any_document())->required();
  add_path(command, "-o,--output", a->out, "SVG document")->required();
  command
      .add_option("--show", a->show,
                  "edges: curves, points, handles. faces: patches and their numbers. errors: of "
                  "merging single edges. motorcycle: the motorcycle graph. regions: those of a "
                  "patch that can be merged within epsilon")
      ->required()
      ->check(CLI::IsMember({"edges", "errors", "motorcycle", "regions", "faces"}));
  add_id(command, a->id);
  add_options(command, a->options.simplify,
              {"color_model", "metric", "epsilon", "resolution", "kappa", "threads"});
  command.add_option("--patch", a->options.patch, "regions: the number of the patch");
  command
      .add_option("--region", a->region,
                  "regions: which one, from 1, by rising size, or all; otherwise the largest")
      ->check(CLI::Validator(region_problem, "NUMBER or all"));
  command.add_flag("--no-picture", a->no_picture, "Leave the picture behind the lines out");
  add_analysis_options(command, a->analyses);
  command.add_flag("--quiet", a->quiet, "Print nothing");
  command.callback([a] { run_draw(*a); });
}

}  // namespace gradmesh
