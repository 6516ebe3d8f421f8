#include "session/edits.h"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include "base/error.h"
#include "fit/plainness.h"
#include "mesh/build.h"
#include "mesh/rectangle.h"
#include "mesh/subdivide.h"
#include "methods/method.h"
#include "methods/plain/grid_fit.h"
#include "methods/plain/plain.h"
#include "methods/plain/steps.h"
#include "ops/merge/merge_faces.h"
#include "ops/split/split_line.h"
#include "ops/split/split_patch.h"
#include "ops/straighten.h"
#include "trial/fit_trial.h"

namespace gradmesh {
namespace {

constexpr int fit_steps = 2, steps_of_the_whole = 4;

Halfedge edge_of(const Pointed& pointed) {
  if (!pointed.edge.valid())
    throw InputError("there is no line inside the mesh here; point at one.");
  return pointed.edge;
}

/// Returns the side of a grid that a side of one of its patches is.
Side side_of_grid(const Mesh& mesh, const Rectangle& grid, Halfedge side) {
  for (int i = 0; i < grid.rows; ++i)
    for (int j = 0; j < grid.columns; ++j) {
      const auto sides = mesh.sides(grid.top(i, j));
      const int k = int(std::ranges::find(sides, side) - sides.begin());
      if (k == 4) continue;
      return {k % 2 == 0 ? Along::rows : Along::columns, i + (k == 2), j + (k == 1)};
    }
  throw std::logic_error("a side of a patch of a grid is a side of the grid");
}

/// Returns the step without the line of a grid that an edge inside it is a part of.
Step step_without(const Mesh& mesh, const Rectangle& grid, Halfedge edge) {
  const auto [along, row, column] = side_of_grid(mesh, grid, edge);
  return {{}, along, along == Along::rows ? row : column};
}

/// The row and the column of a patch in a grid, and which of the patch's own sides is the grid's
/// top.
struct GridPlace {
  int row, column, top;
};

GridPlace place_of(const Mesh& mesh, const Rectangle& grid, Face face) {
  const auto sides = mesh.sides(face);
  for (int i = 0; i < grid.rows; ++i)
    for (int j = 0; j < grid.columns; ++j) {
      const auto top = std::ranges::find(sides, grid.top(i, j));
      if (top != sides.end()) return {i, j, int(top - sides.begin())};
    }
  throw std::logic_error("a patch of a grid is in one of its rows");
}

/// Returns the curves along a line of points of a grid.
std::vector<Halfedge> curves_along(const Mesh& mesh, const Rectangle& grid, Along along, int line) {
  std::vector<Halfedge> curves;
  if (along == Along::rows)
    for (int j = 0; j < grid.columns; ++j)
      curves.push_back(mesh.curve(mesh.sides(grid.top(line - 1, j))[2]));
  else
    for (int i = 0; i < grid.rows; ++i)
      curves.push_back(mesh.curve(mesh.sides(grid.top(i, line - 1))[1]));
  return curves;
}

/// Throws InputError if the mesh is more than a grid of points and handles holds.
PlainGrid plain_grid(const Mesh& mesh) {
  if (const auto why = method_named(plain_method).why_not(mesh)) throw InputError(*why);
  return PlainGrid(mesh);
}

/// Returns the curves of a mesh that is split further which the mesh before does not have.
std::vector<Halfedge> new_curves(const Mesh& before, const Mesh& after) {
  std::vector<Cubic<Value>> known;
  for (const Halfedge curve : before.curves()) known.push_back(before.curve_of(curve));
  std::vector<Halfedge> come;
  for (const Halfedge curve : after.curves()) {
    const Cubic<Value> c = after.curve_of(curve);
    const auto is_same = [&](const Cubic<Value>& other) {
      const auto same = [](const Value& a, const Value& b) { return a.position == b.position; };
      return (same(c.p0, other.p0) && same(c.p1, other.p1)) ||
             (same(c.p0, other.p1) && same(c.p1, other.p0));
    };
    if (std::ranges::none_of(known, is_same)) come.push_back(curve);
  }
  return come;
}

/// Returns a protected patch beside one of the curves, if there is one.
Face protected_beside(const Mesh& mesh, const std::vector<Halfedge>& curves) {
  for (const Halfedge curve : curves)
    for (const Halfedge side : {curve, mesh[curve].twin})
      if (side.valid() && mesh.is_fixed(mesh.face(side))) return mesh.face(side);
  return {};
}

/// A place too near to a side makes a sliver.
double inner_place(double t) { return std::clamp(t, 0.05, 0.95); }

}  // namespace

void check_has_own_colors(const Mesh& mesh) {
  if (mesh.is_smooth())
    throw InputError(
        "the colours of this mesh follow those of the neighbours (type=\"bicubic\"), so that only "
        "whole lines can be taken out.");
}

void check_protected(const Mesh& before, const Mesh& after) {
  for (const Face face : before.faces())
    if (before.is_fixed(face) && before.patch(face) != after.patch(face))
      throw PatchForbids(face, InputError("a patch that would change is protected."));
}

std::vector<std::vector<Halfedge>> inner_lines(const Mesh& mesh) {
  const Rectangle grid = find_grid(mesh).value();
  std::vector<std::vector<Halfedge>> lines;
  for (int i = 1; i < grid.rows; ++i) lines.push_back(curves_along(mesh, grid, Along::rows, i));
  for (int j = 1; j < grid.columns; ++j)
    lines.push_back(curves_along(mesh, grid, Along::columns, j));
  return lines;
}

EditedMesh edit_lines(const Mesh& mesh, const Pointed& pointed, HandEdit edit, bool fits,
                      const Problem& problem) {
  const Rectangle grid = find_grid(mesh).value();
  if (edit == HandEdit::merge) {
    const Step step = step_without(mesh, grid, edge_of(pointed));
    PlainGrid plain = plain_grid(mesh);
    if (!plain.may_take_out(step.along, step.line))
      throw PatchForbids(protected_beside(mesh, curves_along(mesh, grid, step.along, step.line)),
                         InputError("a patch beside this line is protected."));
    make(step, plain);
    if (fits) fit_grid_and_colors(plain, *problem.reference(), fit_steps, points_near(step, plain));
    return {build_derived_mesh(plain.parts()), Message("Take out a line"),
            curves_along(mesh, grid, step.along, step.line)};
  }
  check_has_own_colors(mesh);
  const GridPlace place = place_of(mesh, grid, pointed.face);
  Mesh cut = mesh;
  Journal journal(cut);
  // A patch that is cut keeps its top and its left side.
  if (edit != HandEdit::split_columns)
    split_line_across(journal, mesh.sides(pointed.face)[1], inner_place(pointed.along_left));
  if (edit != HandEdit::split_rows)
    split_line_across(journal, cut.sides(pointed.face)[0], inner_place(pointed.along_top));
  check_protected(mesh, journal.mesh());
  EditedMesh made{build_mesh(subdivided(cut, 1)), edit == HandEdit::split_both
                                                      ? Message("Put in two lines")
                                                      : Message("Put in a line")};
  const Rectangle finer = find_grid(made.mesh).value();
  const auto add = [&](Along along, int line) {
    for (const Halfedge curve : curves_along(made.mesh, finer, along, line))
      made.come.push_back(curve);
  };
  const bool is_turned = place.top % 2 == 1;
  if (edit != HandEdit::split_columns)
    is_turned ? add(Along::columns, place.column + 1) : add(Along::rows, place.row + 1);
  if (edit != HandEdit::split_rows)
    is_turned ? add(Along::rows, place.row + 1) : add(Along::columns, place.column + 1);
  return made;
}

EditedMesh edit_patches(const Mesh& mesh, const Pointed& pointed, HandEdit edit) {
  check_has_own_colors(mesh);
  if (edit == HandEdit::merge) {
    const Halfedge side = mesh.curve_side(edge_of(pointed));
    std::vector<Face> faces;
    for (const Halfedge of_curve : {side, mesh.other_side(side)})
      for (const Halfedge leaf : mesh.leaves(of_curve)) faces.push_back(mesh.face(leaf));
    EditedMesh made = merged_patches(mesh, std::move(faces));
    made.gone = {mesh.curve(side)};
    return made;
  }
  if (mesh.is_fixed(pointed.face))
    throw PatchForbids(pointed.face, InputError("this patch is protected."));
  EditedMesh made{mesh, Message("Split a patch")};
  Journal journal(made.mesh);
  std::optional<double> row, column;
  if (edit != HandEdit::split_columns) row = inner_place(pointed.along_left);
  if (edit != HandEdit::split_rows) column = inner_place(pointed.along_top);
  split_patch(journal, pointed.face, row, column);
  // Where lines meet on both sides of a curve there are ordinary points now.
  made.mesh = build_mesh(subdivided(made.mesh, 1));
  made.come = new_curves(mesh, made.mesh);
  return made;
}

EditedMesh merged_patches(const Mesh& mesh, std::vector<Face> faces) {
  check_has_own_colors(mesh);
  std::ranges::sort(faces);
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  if (faces.size() < 2) throw InputError("that is one patch already; choose two or more.");
  EditedMesh made{mesh, Message("Merge {0} patches", faces.size())};
  const Plainness plain(made.mesh);
  Journal journal(made.mesh);
  const MergedFaces merged = merge_faces(journal, faces);
  if (!merged.face.valid())
    throw InputError(
        "these patches cannot become one, {0}.",
        merged.obstacle == MergeObstacle::none
            ? Message("because they do not touch along a whole side")
            : Message("because of an edge between them: {0}", describe(merged.obstacle)));
  // Twists that no one asked for would be four handles more, in the neighbours too, whose sides
  // change.
  journal.begin();
  plain.keep_coons(journal, 0);
  if (std::ranges::all_of(faces, [&](Face f) { return plain.is_coons(f); }))
    drop_tensor(journal, merged.face);
  made.merged = merged.face;
  for (const Halfedge side : made.mesh.sides(merged.face))
    made.come.push_back(made.mesh.curve(side));
  return made;
}

Mesh fitted(const Mesh& mesh, bool is_gradient, const std::vector<Face>& faces,
            const Problem& problem) {
  if (!is_gradient) {
    const bool masks = problem.rules && problem.rules->may_mask_opacity();
    FitTrial::Fork fork(mesh, EditError(problem.reference(), mesh, masks), true);
    fork.trial.improve(faces, steps_of_the_whole);
    return fork.mesh;
  }
  PlainGrid grid = plain_grid(mesh);
  fit_grid_and_colors(grid, *problem.reference(), steps_of_the_whole, GridPoints::all(grid));
  return build_derived_mesh(grid.parts());
}

}  // namespace gradmesh
