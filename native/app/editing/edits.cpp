#include "app/editing/edits.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <utility>

#include "app/document/frames.h"
#include "app/document/originals.h"
#include "app/document/svg_document.h"
#include "form/counts.h"
#include "mesh/build.h"
#include "mesh/subdivide.h"
#include "ops/color.h"
#include "ops/split/split_line.h"
#include "ops/split/split_patch.h"
#include "session/edits.h"

namespace gradmesh {
namespace {

/// Writes an edited mesh in the place of the entry's mesh. If it is `meant_to_differ`, it forgets
/// its original, so that it counts as the original itself.
EditReport write(Document& document, const MeshEntry& entry, const Mesh& edited,
                 const MeasureOptions& measure, bool meant_to_differ = false) {
  EditReport report{entry.id, counts_of(document.mesh(entry)), {}, 0, 0};
  std::shared_ptr<const Mesh> against = known_original(document, entry);
  if (!against) against = std::make_shared<const Mesh>(document.mesh(entry));
  const auto [written, frame] = document.naming(entry, [&] {
    Problem problem(against, nullptr, layout_of(document, entry, true), measure.resolution,
                    measure.metric);
    // A rectangle that was one mesh gradient stays one, unless its colours are sharp somewhere.
    problem.rules = document.rules(entry, find_grid(edited) && has_one_color_at_each_point(edited));
    return std::pair(problem.measure(edited), problem.frame());
  });
  WriteOptions writing;
  writing.remember_original = !meant_to_differ && document.remembers_when_edited(entry);
  document.write({{entry, written, counts_of(*against), frame, against}}, measure.metric, writing);
  report.after = written.counts();
  report.objects = written.form.object_count();
  report.error = written.error;
  return report;
}

/// Splits along lines across the whole mesh that start on `side` of the faces, at `place`. A face
/// that the line of another one has cut is left: its side `crossed` ends somewhere else.
void split_lines(Journal& journal, const std::vector<Face>& faces, std::size_t side,
                 std::size_t crossed, double place) {
  const Mesh& mesh = journal.mesh();
  const auto ends = [&](Face f) {
    const Halfedge h = mesh.sides(f)[crossed];
    return std::pair(mesh.origin(h), mesh.end(h));
  };
  std::vector<std::pair<Point, Point>> before;
  for (const Face f : faces) before.push_back(ends(f));
  for (std::size_t i = 0; i < faces.size(); ++i)
    if (ends(faces[i]) == before[i]) split_line_across(journal, mesh.sides(faces[i])[side], place);
}

void split_faces(Journal& journal, const std::vector<Face>& faces, const RefineOptions& options) {
  if (options.whole) {
    if (options.rows) split_lines(journal, faces, 1, 3, options.place);
    if (options.columns) split_lines(journal, faces, 0, 0, options.place);
    return;
  }
  std::optional<double> row, column;
  if (options.rows) row = options.place;
  if (options.columns) column = options.place;
  for (const Face f : faces) split_patch(journal, f, row, column);
}

/// Points in the mesh of an entry, and the corners there whose colours are changed.
struct ChosenCorners {
  MeshEntry entry;
  std::vector<Point> points;
  std::vector<Halfedge> corners;
};

Point point_numbered(const Document& document, const Mesh& mesh, int number) {
  const int count = int(std::ranges::distance(mesh.points()));
  if (number < 0 || number >= count)
    throw InputError("{0}: there is no point {1}; the last is {2}.", document.name(), number,
                     count - 1);
  return Point{number};
}

/// Throws InputError if one of the patches has no corner among those that are chosen.
void check_all_are_there(const Document& document, const Mesh& mesh, const ChosenCorners& chosen,
                         const std::vector<int>& patches) {
  for (const int number : patches) {
    const Face face = face_numbered(document, chosen.entry, number);
    if (std::ranges::none_of(chosen.corners, [&](Halfedge h) { return mesh.face(h) == face; }))
      throw InputError("{0}: patch {1} has no corner at these points.", document.name(), number);
  }
}

ChosenCorners chosen_corners(const Document& document, const PointChoice& choice) {
  ChosenCorners chosen{one_mesh(document, choice.id), {}, {}};
  check_editable(document, chosen.entry);
  if (choice.points.empty()) throw InputError("{0}: no points are chosen.", document.name());
  const Mesh& mesh = document.mesh(chosen.entry);
  const auto is_chosen = [&](Halfedge corner) {
    return choice.patches.empty() ||
           std::ranges::find(choice.patches, mesh.face(corner).value) != choice.patches.end();
  };
  for (const int number : choice.points) {
    chosen.points.push_back(point_numbered(document, mesh, number));
    const std::size_t before = chosen.corners.size();
    std::ranges::copy_if(corners_at(mesh, chosen.points.back()), std::back_inserter(chosen.corners),
                         is_chosen);
    if (chosen.corners.size() == before)
      throw InputError("{0}: none of these patches has a corner at point {1}.", document.name(),
                       number);
  }
  check_all_are_there(document, mesh, chosen, choice.patches);
  return chosen;
}

}  // namespace

std::vector<UpdateReport> update(Document& document, const std::vector<std::string>& ids) {
  return as_svg(document,
                Message("{0}: only meshes that were simplified in an SVG document can be updated.",
                        document.name()))
      .update(ids);
}

EditReport merge(Document& document, const PatchChoice& choice, const MeasureOptions& measure) {
  if (choice.is_empty())
    throw InputError("{0}: no patches are chosen to be merged.", document.name());
  const ChosenFaces chosen = chosen_faces(document, choice);
  const bool names_some = !choice.patches.empty() || choice.rows || choice.columns;
  if (!names_some && std::ranges::find(choice.ids, chosen.entry.id) != choice.ids.end())
    throw InputError("{0}: please choose rows and columns of it, or blocks, not all of it.",
                     document.describe(chosen.entry));
  const Mesh merged = document.naming(
      chosen.entry, [&] { return merged_patches(document.mesh(chosen.entry), chosen.faces).mesh; });
  return write(document, chosen.entry, merged, measure);
}

EditReport refine(Document& document, const PatchChoice& choice, const RefineOptions& options,
                  const MeasureOptions& measure) {
  if (!(options.place > 0 && options.place < 1))
    throw std::invalid_argument("the place of a split must be above 0 and below 1.");
  if (!options.rows && !options.columns)
    throw std::invalid_argument("patches are split into rows, columns or both.");
  const ChosenFaces chosen = chosen_faces(document, choice);
  Mesh mesh = document.mesh(chosen.entry);
  Journal journal(mesh);
  split_faces(journal, chosen.faces, options);
  // Where lines meet on both sides of a curve there are ordinary points now.
  return write(document, chosen.entry, build_mesh(subdivided(mesh, 1)), measure);
}

EditReport recolor(Document& document, const PointChoice& choice, const glm::dvec3& color,
                   const MeasureOptions& measure) {
  const ChosenCorners chosen = chosen_corners(document, choice);
  Mesh mesh = document.mesh(chosen.entry);
  Journal journal(mesh);
  for (const Halfedge corner : chosen.corners)
    recolor(journal, corner, {color, mesh[corner].color.a});
  return write(document, chosen.entry, mesh, measure, true);
}

EditReport join_colors(Document& document, const PointChoice& choice,
                       const MeasureOptions& measure) {
  const ChosenCorners chosen = chosen_corners(document, choice);
  Mesh mesh = document.mesh(chosen.entry);
  Journal journal(mesh);
  for (const Point point : chosen.points) join_colors(journal, point);
  return write(document, chosen.entry, mesh, measure, true);
}

}  // namespace gradmesh
