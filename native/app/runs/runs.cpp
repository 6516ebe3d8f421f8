#include "app/runs/runs.h"

#include <sstream>
#include <stdexcept>

#include "app/document/frames.h"
#include "app/document/originals.h"
#include "app/document/weighted_shapes.h"
#include "app/runs/devices.h"
#include "app/runs/mesh_runs.h"
#include "mesh/build.h"
#include "mesh/color_model.h"
#include "mesh/faces_under.h"
#include "mesh/subdivide.h"
#include "ops/fix.h"
#include "simplify/target.h"
#include "simplify/tries.h"

namespace gradmesh {
namespace {

void check_edges(const SimplifyOptions& options) {
  const bool are_named = method_named(options.method).merges_named_edges;
  if (are_named && options.edges.empty())
    throw std::invalid_argument("the method manual needs the edges to merge.");
  if (!are_named && !options.edges.empty())
    throw std::invalid_argument("edges can be named for the method manual only.");
}

void check_saved(const SimplifyOptions& options, const PricePaths& analyses) {
  if (!analyses.save.empty() && !method_named(options.method).needs_prices)
    throw std::invalid_argument("the method " + options.method +
                                " needs no analysis, so there is none to save.");
}

/// Returns the mesh in the colour model that is asked for.
std::shared_ptr<const Mesh> in_color_model(const Mesh& mesh, ColorModel model) {
  if (model == mesh.color_model()) return std::make_shared<const Mesh>(mesh);
  MeshParts parts = subdivided(mesh, 1);
  return std::make_shared<const Mesh>(build_mesh(model == ColorModel::bilinear
                                                     ? as_bilinear(std::move(parts))
                                                     : as_bicubic(std::move(parts))));
}

/// Returns the mesh of an entry with the patches fixed of which what is protected covers something.
std::shared_ptr<const Mesh> protecting(const Document& document, const MeshEntry& entry,
                                       std::shared_ptr<const Mesh> mesh,
                                       const RunOptions& options) {
  std::vector<FilledOutline> areas = options.protect_areas;
  if (!options.protect.empty())
    for (FilledOutline& area : document.covered(options.protect)) areas.push_back(std::move(area));
  if (areas.empty()) return mesh;
  const Affine to_mesh = document.view(entry).inverse();
  std::vector<Face> faces;
  for (FilledOutline& area : areas) {
    area.outline = mapped(std::move(area.outline), to_mesh);
    const std::vector<Face> under = faces_under(*mesh, area);
    faces.insert(faces.end(), under.begin(), under.end());
  }
  return std::make_shared<const Mesh>(with_fixed(*mesh, faces));
}

/// Returns the device on which a run prices merges of the mesh; null for the cores alone.
std::shared_ptr<Device> device_for(const Mesh& mesh, const RunOptions& options) {
  if (options.device || !options.device_if_faster) return options.device;
  const Frame frame = fit_frame(mesh, options.view, options.resolution, options.padding);
  return automatic_device(mesh, frame, options.metric, options.threads);
}

/// What became of the selected meshes, and what of that is to be written.
struct Simplified {
  std::vector<MeshReport> reports;
  std::vector<ChangedMesh> changed;
};

Simplified simplified(const Document& document, const std::vector<std::string>& ids,
                      const RunOptions& options, const PricePaths& analyses) {
  check_edges(options);
  check_saved(options, analyses);
  const std::vector<MeshEntry> entries = document.selected(ids);
  if (method_named(options.method).merges_named_edges && entries.size() > 1)
    throw InputError("{0}: there are {1} meshes, and edges can be named of one only.",
                     document.name(), entries.size());

  // All meshes are read before the first run, as a run may take long.
  PriceFiles files(analyses);
  MeshRuns runs(document, options);
  RunOptions telling = options;
  telling.device_lost = runs.telling_device_lost();
  for (const MeshEntry& entry : entries)
    runs.add(entry, problem_of(document, entry, telling, files));
  Simplified all;
  for (MeshRun& run : std::move(runs).run()) {
    SimplifyResult& result = *run.result;
    if (!result.changed)
      result.objects = document.objects(run.entry);
    else
      all.changed.push_back({run.entry,
                             result,
                             {result.handles_before, result.patches_before},
                             run.frame,
                             run.original});
    all.reports.push_back({run.entry.id, std::move(result)});
  }
  for (const MeshEntry& entry : document.refused(ids)) {
    MeshReport& report = all.reports.emplace_back();
    report.id = entry.id;
    report.refused = entry.refused;
  }
  files.save();
  return all;
}

}  // namespace

Problem problem_of(const Document& document, const MeshEntry& entry, const RunOptions& asked,
                   PriceFiles& files) {
  RunOptions options = asked;
  const Mesh& read = document.mesh(entry);
  const ColorModel model = asked.color_model.value_or(read.color_model());
  if (asked.color_model) document.check_color_model(model);
  if (!options.original) options.original = original_of(given_original(document, entry));
  if (!options.original) options.original = document.traced_original(entry, options.resolution);
  if (!options.original) options.original = original_of(known_original(document, entry));
  std::shared_ptr<const Mesh> mesh = in_color_model(read, model);
  mesh = protecting(document, entry, std::move(mesh), asked);
  if (!options.original && model != read.color_model())
    options.original = original_of(std::make_shared<const Mesh>(read));
  static_cast<Layout&>(options) = layout_of(document, entry, asked.visible_only);
  options.weighted = weighted_shapes(document, asked.weights, document.view(entry).inverse());
  options.count = what_is_counted(asked, document.format().count);
  options.rules = document.rules(entry, false);
  if (document.is_one_gradient(entry)) options.gradient_rules = document.rules(entry, true);
  options.analysis = nullptr;
  const Problem problem = document.naming(entry, [&] {
    const Problem made = problem_of(mesh, options);
    return made.within(made.beyond_start(made.bounds));
  });
  problem.price_with({&files.start(problem.price_key(), *mesh),
                      [=] { return device_for(*mesh, options); }, asked.device_lost});
  return problem;
}

std::vector<MeshReport> simplify(Document& document, const std::vector<std::string>& ids,
                                 const RunOptions& options, const PricePaths& analyses,
                                 const WriteOptions& writing) {
  document.check_writing(writing);
  const Simplified all = simplified(document, ids, options, analyses);
  if (!all.changed.empty()) document.write(all.changed, options.metric, writing);
  return all.reports;
}

std::vector<MeshReport> preview(const Document& document, const std::vector<std::string>& ids,
                                RunOptions options, const PricePaths& analyses) {
  if (method_named(options.method).merges_named_edges) {
    options.epsilon = 1;
    options.max_local_error.reset();
    options.max_detail_error.reset();
  }
  return simplified(document, ids, options, analyses).reports;
}

std::size_t analyze(const Document& document, const std::vector<std::string>& ids,
                    const RunOptions& options, const PricePaths& analyses) {
  PriceFiles files(analyses);
  std::size_t prices = 0;
  for (const MeshEntry& entry : document.selected(ids)) {
    const Problem problem = problem_of(document, entry, options, files);
    StopWatch watch = watch_of(options);
    document.naming(entry, [&] { analyze_regions(problem, watch); });
    prices += problem.prices().prices.size();
  }
  files.save();
  return prices;
}

}  // namespace gradmesh
