#include "draw/draw.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "cli/commands.h"
#include "cli/common_options.h"
#include "cli/one_mesh.h"
#include "cli/progress_bar.h"
#include "draw/backdrop.h"
#include "draw/svg_drawing.h"
#include "io/atomic_file.h"

namespace gradmesh {
namespace {

struct DrawArguments {
  std::string in, out, id, show, metric = "flip", region;
  std::optional<int> patch;
  SimplifyOptions options;
  AnalysisPaths analyses;
  bool no_picture = false, quiet = false;
};

/// One mesh of a document, and the prices that its drawings need.
class Draw {
 public:
  explicit Draw(const DrawArguments& a)
      : a_(a),
        files_(a.analyses),
        document_(Document::read_file(a.in)),
        entry_(one_mesh(*document_, a.id)),
        start_(document_->start(entry_, a.options, files_)),
        mesh_(start_.mesh),
        subject_(mesh_, start_.options.view) {}

  std::string text() const {
    Drawing drawing = this->drawing();
    drawing.title = "Gradient mesh " + entry_.id;
    // The patches are pictures themselves.
    if (!a_.no_picture && a_.show != "faces") {
      const Frame frame = document_->frame(entry_, mesh_, a_.options.resolution);
      drawing.picture = backdrop(make_software_rasterizer()->paint(mesh_, frame), frame,
                                 start_.options.view, a_.show != "edges");
    }
    return svg_text(drawing);
  }

 private:
  Drawing drawing() const {
    if (a_.show == "edges") return draw_edges(subject_);
    if (a_.show == "faces") return draw_faces(subject_);
    ProgressBar bar(a_.quiet);
    SimplifyOptions options = start_.options;
    options.progress = bar.callback();
    Drawing drawing = priced_drawing(options);
    files_.save();
    return drawing;
  }

  Drawing priced_drawing(const SimplifyOptions& options) const {
    if (a_.show == "regions") return regions(analyze_regions(mesh_, options));
    const std::vector<EdgePrice> prices = analyze_edges(mesh_, options);
    if (a_.show == "errors") return draw_errors(subject_, prices, measure());
    const double limit = options.kappa * options.epsilon;
    return draw_motorcycle(subject_, motorcycle_graph(mesh_, prices, limit), limit);
  }

  std::string measure() const {
    return std::string(a_.options.metric == MetricKind::flip ? "FLIP" : "1 - SSIM") + " at " +
           std::to_string(a_.options.resolution) + " pixels";
  }

  Drawing regions(const std::vector<RegionPrice>& all) const {
    const Face patch = chosen_patch(all);
    const std::vector<RegionPrice> found = regions_with(mesh_, all, patch);
    return draw_regions(subject_, patch, found, chosen_region(patch, int(found.size())));
  }

  /// That of --patch, or one of the largest region.
  Face chosen_patch(const std::vector<RegionPrice>& regions) const {
    if (!a_.patch) return regions.empty() ? *mesh_.faces().begin() : regions.back().region.face;
    const Face patch{*a_.patch};
    if (patch.value < 0 || patch.value >= int(mesh_.face_slots()))
      throw InputError(a_.in + ": there is no patch " + std::to_string(patch.value) +
                       "; the last is " + std::to_string(mesh_.face_slots() - 1) + ".");
    return patch;
  }

  /// That of --region, or the largest; -1: all.
  int chosen_region(Face patch, int count) const {
    if (a_.region == "all") return -1;
    const int chosen = a_.region.empty() ? count : std::stoi(a_.region);
    if (chosen > count)
      throw InputError(a_.in + ": patch " + std::to_string(patch.value) + " has " +
                       std::to_string(count) + " regions only.");
    return chosen - 1;
  }

  const DrawArguments& a_;
  AnalysisFiles files_;
  std::unique_ptr<Document> document_;
  MeshEntry entry_;
  Document::Start start_;
  const Mesh& mesh_;
  Subject subject_;
};

/// What is wrong with the value of --region; empty: nothing.
std::string region_problem(const std::string& text) {
  int number = 0;
  if (text == "all" || (CLI::detail::lexical_cast(text, number) && number > 0)) return "";
  return "must be a whole number from 1, or all";
}

void run_draw(DrawArguments& a) {
  if (a.show != "regions" && (a.patch || !a.region.empty()))
    throw std::invalid_argument("--patch and --region go with --show regions only.");
  a.options.metric = metric_named(a.metric);
  write_bytes(a.out, Draw(a).text());
}

}  // namespace

void add_draw(CLI::App& program) {
  const auto a = std::make_shared<DrawArguments>();
  CLI::App& command = *program.add_subcommand("draw", "Draw a mesh and what is known about it");
  command.add_option("IN", a->in, "SVG document or .hemesh file")->required();
  command.add_option("-o,--output", a->out, "SVG document")->required();
  command
      .add_option("--show", a->show,
                  "edges: curves, points, handles. faces: patches and their numbers. errors: of "
                  "merging single edges. motorcycle: the motorcycle graph. regions: those of a "
                  "patch that can be merged within epsilon")
      ->required()
      ->check(CLI::IsMember({"edges", "errors", "motorcycle", "regions", "faces"}));
  command.add_option("--id", a->id, "Which mesh, where there are several");
  add_color_model_option(command, a->options.color_model);
  add_metric_option(command, a->metric);
  add_epsilon_option(command, a->options.epsilon);
  add_resolution_option(command, a->options.resolution);
  add_kappa_option(command, a->options.kappa);
  command.add_option("--patch", a->patch, "regions: the number of the patch");
  command
      .add_option("--region", a->region,
                  "regions: which one, from 1, by rising size, or all; otherwise the largest")
      ->check(CLI::Validator(region_problem, "NUMBER or all"));
  command.add_flag("--no-picture", a->no_picture, "Leave the picture behind the lines out");
  add_analysis_options(command, a->analyses);
  add_threads_option(command, a->options.threads);
  command.add_flag("--quiet", a->quiet, "Print nothing");
  command.callback([a] { run_draw(*a); });
}

}  // namespace gradmesh
