#include "app/export/draw_document.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "app/document/frames.h"
#include "app/editing/patch_choice.h"
#include "draw/backdrop.h"
#include "draw/draw.h"
#include "draw/svg_drawing.h"
#include "raster/rasterizer.h"

namespace gradmesh {
namespace {

/// One mesh of a document, and the prices that its drawings need.
class Draw {
 public:
  Draw(const Document& document, const MeshEntry& entry, const DrawOptions& options,
       const PricePaths& analyses)
      : document_(document),
        entry_(entry),
        options_(options),
        files_(analyses),
        problem_(problem_of(document, entry, options.simplify, files_)),
        mesh_(problem_.mesh()),
        subject_(mesh_, document.view(entry), document.translation()) {}

  std::string text() {
    Drawing drawing = this->drawing();
    drawing.title = "Gradient mesh " + entry_.id;
    // The patches are pictures themselves.
    if (options_.picture && options_.show != Show::faces) {
      const Frame frame = frame_of(document_, entry_, mesh_, options_.simplify.resolution);
      drawing.picture = backdrop(make_software_rasterizer()->paint(mesh_, frame), frame,
                                 document_.view(entry_), options_.show != Show::edges);
    }
    return svg_text(drawing);
  }

 private:
  Drawing drawing() {
    if (options_.show == Show::edges) return draw_edges(subject_);
    if (options_.show == Show::faces) return draw_faces(subject_);
    Drawing drawing = priced_drawing();
    files_.save();
    return drawing;
  }

  Drawing priced_drawing() const {
    const RunOptions& options = options_.simplify;
    StopWatch watch = watch_of(options);
    if (options_.show == Show::regions) {
      return regions(document_.naming(entry_, [&] { return analyze_regions(problem_, watch); }));
    }
    const std::vector<EdgePrice> prices =
        document_.naming(entry_, [&] { return analyze_edges(problem_, watch); });
    if (options_.show == Show::errors) return draw_errors(subject_, prices, measure());
    const double limit = options.kappa * options.epsilon;
    return draw_motorcycle(subject_, motorcycle_graph(mesh_, prices, limit), limit);
  }

  std::string measure() const {
    return subject_.say(Message("{0} at {1} pixels", label(options_.simplify.metric),
                                options_.simplify.resolution));
  }

  Drawing regions(const std::vector<RegionPrice>& all) const {
    const Face patch = chosen_patch(all);
    const std::vector<RegionPrice> found = regions_with(all, patch);
    return draw_regions(subject_, patch, found, chosen_region(patch, int(found.size())));
  }

  Face chosen_patch(const std::vector<RegionPrice>& regions) const {
    if (!options_.patch)
      return regions.empty() ? *mesh_.faces().begin() : regions.back().region.face;
    return face_numbered(document_, entry_, *options_.patch);
  }

  /// Returns the index of the chosen region as in draw_regions(), -1 for all.
  int chosen_region(Face patch, int count) const {
    const int chosen = options_.region.value_or(count);
    if (chosen > count)
      throw InputError("{0}: patch {1} has {2} regions only.", document_.name(), patch.value,
                       count);
    return chosen - 1;
  }

  const Document& document_;
  const MeshEntry entry_;
  const DrawOptions& options_;
  PriceFiles files_;
  const Problem problem_;
  const Mesh& mesh_;
  const Subject subject_;
};

}  // namespace

std::string draw(const Document& document, const MeshEntry& entry, const DrawOptions& options,
                 const PricePaths& analyses) {
  if (options.show != Show::regions && (options.patch || options.region))
    throw std::invalid_argument("a patch and a region are named for drawings of regions only.");
  return Draw(document, entry, options, analyses).text();
}

Show show_named(const std::string& name) {
  static constexpr std::array<std::pair<const char*, Show>, 5> names{
      {{"edges", Show::edges},
       {"faces", Show::faces},
       {"errors", Show::errors},
       {"motorcycle", Show::motorcycle},
       {"regions", Show::regions}}};
  for (const auto& [known, show] : names)
    if (name == known) return show;
  throw std::invalid_argument("there is no drawing '" + name +
                              "'; there are: edges, errors, faces, motorcycle, regions.");
}

}  // namespace gradmesh
