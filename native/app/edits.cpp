#include "app/edits.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "app/svg_meshes.h"
#include "app/svg_rules.h"
#include "fit/plainness.h"
#include "formats/text/excerpt.h"
#include "mesh/build.h"
#include "mesh/rectangle.h"
#include "mesh/subdivide.h"
#include "ops/merge/merge_faces.h"
#include "ops/split/split.h"
#include "ops/split/split_line.h"
#include "ops/straighten.h"
#include "problem/problem.h"

namespace gradmesh {
namespace {

SvgMeshes& svg(Document& document) {
  return document.as_svg(
      Message("{0}: patches are edited in SVG documents only.", document.name()));
}

EditReport write(SvgMeshes& document, const MeshEntry& entry, const Mesh& mesh,
                 const MeasureOptions& measure) {
  const std::string id = entry.id;
  const MeshCounts before = counts_of(document.mesh(entry));
  const auto [after, objects, error] =
      document.rewrite(entry, mesh, measure.metric, measure.resolution);
  return {id, before, after, objects, error};
}

/// Cuts patches of a rectangle.
class Refiner {
 public:
  Refiner(Journal& journal, const Rectangle& chosen, const RefineOptions& options)
      : journal_(journal),
        mesh_(journal.mesh()),
        columns_in_all_(chosen.columns),
        options_(options),
        rows_(range(options.row, chosen.rows)),
        columns_(range(options.column, chosen.columns)) {
    for (const Halfedge top : chosen.tops) faces_.push_back(mesh_.face(top));
    if (rows_.first < 0 || rows_.second > chosen.rows)
      throw InputError("it has no row {0}, only {1} of them.", rows_.second, chosen.rows);
    if (columns_.first < 0 || columns_.second > chosen.columns)
      throw InputError("it has no column {0}, only {1} of them.", columns_.second, chosen.columns);
  }

  void run() {
    if (options_.whole) {
      split_lines();
    } else {
      for (int i = rows_.first; i < rows_.second; ++i)
        for (int j = columns_.first; j < columns_.second; ++j) split_patch(face(i, j));
    }
  }

 private:
  using Range = std::pair<int, int>;

  static Range range(std::optional<int> number, int count) {
    return number ? Range(std::max(*number, 0) - 1, *number) : Range(0, count);
  }

  Face face(int row, int column) const {
    return faces_[std::size_t(row) * std::size_t(columns_in_all_) + std::size_t(column)];
  }

  void split_patch(Face f) {
    const double t = options_.place;
    const Halfedge top = mesh_.sides(f)[0];
    if (!options_.rows) {
      split(journal_, top, t);
      return;
    }
    // The new edge is the bottom of what lies above it.
    const Halfedge bottom = split(journal_, mesh_.sides(f)[1], t);
    if (!options_.columns) return;
    const Halfedge below = mesh_[bottom].twin;
    split(journal_, mesh_.next(mesh_.next(bottom)), t);
    split(journal_, below, t);
  }

  /// Splits along the chosen lines. A patch that is cut keeps its top and its left side, from which
  /// the next line starts.
  void split_lines() {
    if (options_.rows)
      for (int i = rows_.first; i < rows_.second; ++i)
        split_line_across(journal_, mesh_.sides(face(i, columns_.first))[1], options_.place);
    if (options_.columns)
      for (int j = columns_.first; j < columns_.second; ++j)
        split_line_across(journal_, mesh_.sides(face(rows_.first, j))[0], options_.place);
  }

  Journal& journal_;
  const Mesh& mesh_;
  /// The patches as they were chosen, row by row: a patch that is cut keeps its face.
  std::vector<Face> faces_;
  const int columns_in_all_;
  const RefineOptions& options_;
  const Range rows_, columns_;
};

constexpr int most_patches = 100000;

/// Returns true if all patches that meet at a point have one colour there, but for rounding to 8
/// bits.
bool has_one_color_at_each_point(const Mesh& mesh) {
  std::map<Point, glm::dvec4> colors;
  for (const Face f : mesh.faces()) {
    const Patch patch = mesh.patch(f);
    const auto sides = mesh.sides(f);
    for (int k = 0; k < 4; ++k) {
      const glm::dvec4 color = patch.corner(k).color;
      const auto [known, is_new] = colors.emplace(mesh.origin(sides[std::size_t(k)]), color);
      for (int i = 0; i < 4; ++i)
        if (std::abs(known->second[i] - color[i]) > 1.001 / 255) return false;
    }
  }
  return true;
}

/// Returns the surface of the mesh as one grid.
Mesh as_grid(Mesh mesh) {
  Journal journal(mesh);
  extend_stems(journal, most_patches);
  Mesh plain = build_mesh(subdivided(mesh, 1));
  if (!find_grid(plain)) throw InputError("its patches do not make up one rectangle.");
  if (!has_one_color_at_each_point(plain))
    throw InputError("it has several colours at one point, which one mesh gradient cannot hold.");
  return plain;
}

}  // namespace

std::vector<EditReport> to_one_mesh(Document& document, const std::vector<std::string>& ids,
                                    const MeasureOptions& measure) {
  SvgMeshes& meshes = svg(document);
  std::vector<std::pair<MeshEntry, Mesh>> grids;
  std::vector<EditReport> reports;
  for (const MeshEntry& entry : meshes.selected(ids)) {
    if (!entry.simplified) continue;
    const Mesh before = meshes.mesh(entry);
    const Mesh& grid =
        grids.emplace_back(entry, meshes.naming(entry, [&] { return as_grid(before); })).second;
    const Candidate written = meshes.naming(entry, [&] {
      Problem problem(std::make_shared<const Mesh>(before), nullptr, meshes.layout(entry, false),
                      measure.resolution, measure.metric);
      problem.rules = gradient_rules({});
      return problem.measure(grid);
    });
    reports.push_back({entry.id, counts_of(before), written.counts(), 1, written.error});
  }
  if (grids.empty())
    throw InputError("{0}: only simplified meshes can be made one mesh gradient.", document.name());
  meshes.write_as_one(grids, measure.resolution);
  return reports;
}

EditReport merge_blocks(Document& document, const std::vector<std::string>& ids,
                        const MeasureOptions& measure) {
  SvgMeshes& meshes = svg(document);
  if (ids.empty()) throw InputError("{0}: no blocks are chosen to be merged.", document.name());
  std::vector<Face> faces;
  std::optional<MeshEntry> entry;
  for (const std::string& id : ids) {
    const ChosenPatches block = meshes.block(id);
    if (entry && entry->index != block.entry.index)
      throw InputError("{0}: the blocks {1} and {2} are of different meshes.", document.name(),
                       excerpt(ids.front()), excerpt(id));
    entry = block.entry;
    for (const Halfedge top : block.rectangle.tops)
      faces.push_back(meshes.mesh(block.entry).face(top));
  }
  std::ranges::sort(faces);
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  if (faces.size() < 2)
    throw InputError("{0}: {1} is one patch already; choose two or more.", document.name(),
                     excerpt(ids.front()));

  Mesh mesh = meshes.mesh(*entry);
  const Plainness plain(mesh);
  Journal journal(mesh);
  const MergedFaces merged = merge_faces(journal, faces);
  if (!merged.face.valid()) {
    const Message why =
        merged.obstacle == MergeObstacle::none
            ? Message("because they do not touch along a whole side")
            : Message("because of an edge between them: {0}", describe(merged.obstacle));
    throw InputError("{0}: {1}: these patches cannot become one, {2}.", document.name(), entry->id,
                     why);
  }
  // Twists that no one asked for would be four handles more, in the neighbours too, whose sides
  // change.
  journal.begin();
  plain.keep_coons(journal, 0);
  if (std::ranges::all_of(faces, [&](Face f) { return plain.is_coons(f); }))
    drop_tensor(journal, merged.face);
  return write(meshes, *entry, mesh, measure);
}

EditReport refine(Document& document, const std::string& id, const RefineOptions& options,
                  const MeasureOptions& measure) {
  if (!(options.place > 0 && options.place < 1))
    throw std::invalid_argument("the place of a split must be above 0 and below 1.");
  if (!options.rows && !options.columns)
    throw std::invalid_argument("patches are split into rows, columns or both.");
  SvgMeshes& meshes = svg(document);
  const ChosenPatches chosen = meshes.rectangle(id);
  Mesh mesh = meshes.mesh(chosen.entry);
  Journal journal(mesh);
  try {
    Refiner(journal, chosen.rectangle, options).run();
  } catch (const InputError& error) {
    throw InputError("{0}: {1}: {2}", document.name(), excerpt(id), error.message());
  }
  // Where lines meet on both sides of a curve there are ordinary points now.
  return write(meshes, chosen.entry, build_mesh(subdivided(mesh, 1)), measure);
}

}  // namespace gradmesh
