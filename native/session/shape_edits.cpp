#include "session/shape_edits.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <utility>

#include "base/error.h"
#include "fit/fit.h"
#include "fit/plainness.h"
#include "form/handles.h"
#include "ops/color.h"
#include "ops/straighten.h"

namespace gradmesh {
namespace {

Halfedge curve_of_side(const Mesh& mesh, const Pointed& pointed) {
  if (!pointed.side.valid()) throw InputError("there is no side of a patch here; point at one.");
  return mesh.curve(pointed.side);
}

/// Throws InputError if a curve leaves the frame: what is beyond is not measured.
void check_in_frame(const Mesh& mesh, Halfedge curve, const Frame& frame) {
  for (const glm::dvec2 p : points_along(mesh.curve_of(curve), frame.to_pixels))
    if (!(p.x >= 0 && p.y >= 0 && p.x <= frame.width && p.y <= frame.height))
      throw InputError("this is beyond the mesh as it was at first, where no error is measured.");
}

/// Gives a straight curve handles beside those of a line, by less than can be seen, so that it
/// counts as a curve.
void bend_by_a_hair(Journal& journal, Halfedge curve) {
  const Mesh& mesh = journal.mesh();
  const glm::dvec2 chord = mesh.position(mesh.end(curve)) - mesh.position(mesh.origin(curve));
  const double length = glm::length(chord);
  if (length == 0) throw InputError("this side has no length.");
  const double hair = 6 * rounding_of(mesh);
  journal.begin();
  const glm::dvec2 aside = hair / length * glm::dvec2(-chord.y, chord.x);
  for (const Handle handle : mesh[curve].handles) journal.edit(handle).tangent.position += aside;
}

/// Moves the two handles of a curve to where the patches beside it are closest to the picture.
void fit_handles(Journal& journal, Halfedge curve, const Reference& picture) {
  const Mesh& mesh = journal.mesh();
  std::vector<Face> faces;
  for (const Halfedge side : {curve, mesh[curve].twin})
    if (side.valid())
      for (const Halfedge leaf : mesh.leaves(side)) faces.push_back(mesh.face(leaf));
  Fit fit(journal, picture, faces, Plainness(mesh));
  Damping damping(fit.unknowns().size());
  std::vector<bool> stays;
  for (const Unknown& unknown : fit.unknowns()) {
    stays.push_back(unknown.kind != Unknown::tangent || unknown.curve != curve);
    if (stays.back()) damping.hold(stays.size() - 1);
  }
  constexpr int steps = 4;
  for (int i = 0; i < steps; ++i) fit.apply(fit.step(damping), stays);
}

/// Returns the corner that is pointed at, or all around its point.
std::vector<Halfedge> corners_of(const Mesh& mesh, const Pointed& pointed, bool is_alone) {
  if (!pointed.corner.valid())
    throw InputError("there is no point of the mesh here; point at one.");
  if (is_alone) return {pointed.corner};
  return corners_at(mesh, mesh.origin(pointed.corner));
}

void check_can_recolor(const Mesh& mesh, const std::vector<Halfedge>& corners) {
  if (!std::ranges::all_of(corners, [&](Halfedge corner) { return can_recolor(mesh, corner); }))
    throw InputError("a patch that would change is protected.");
}

}  // namespace

EditedMesh straightened(const Mesh& mesh, const Pointed& pointed) {
  const Halfedge curve = curve_of_side(mesh, pointed);
  const Plainness plain(mesh);
  if (plain.is_straight(curve)) throw InputError("this side is straight already.");
  EditedMesh made{mesh, Message("Make a side straight"), {curve}, {curve}};
  Journal journal(made.mesh);
  journal.begin();
  straighten(journal, curve);
  plain.refresh(journal, std::array{curve});
  check_protected(mesh, journal.mesh());
  return made;
}

EditedMesh bent(const Mesh& mesh, const Pointed& pointed, const Reference& picture) {
  const Halfedge curve = curve_of_side(mesh, pointed);
  Plainness plain(mesh);
  if (!plain.is_straight(curve)) throw InputError("this side is a curve already.");
  if (mesh.is_smooth())
    throw InputError(
        "the colours of this mesh follow those of the neighbours (type=\"bicubic\"), so that sides "
        "become curves only where a handle is moved.");
  EditedMesh made{mesh, Message("Make a side a curve"), {}, {curve}};
  Journal journal(made.mesh);
  bend_by_a_hair(journal, curve);
  plain.let_bend(curve);
  plain.refresh(journal, std::array{curve});
  fit_handles(journal, curve, picture);
  check_protected(mesh, journal.mesh());
  return made;
}

EditedMesh moved(const Mesh& mesh, const Grip& grip, glm::dvec2 to, const Problem& problem) {
  Plainness plain(mesh);
  const bool is_point = grip.point.valid();
  const std::vector<Halfedge> curves =
      is_point ? plain.curves_at(grip.point) : std::vector{grip.curve};
  EditedMesh made{mesh, is_point ? Message("Move a point") : Message("Move a handle"), curves,
                  curves};
  made.redraws = true;
  Journal journal(made.mesh);
  journal.begin();
  if (is_point) {
    journal.edit(grip.point).position = to;
  } else {
    const Cubic<Value> c = mesh.curve_of(grip.curve);
    const glm::dvec2 from = (grip.is_at_end ? c.p1 : c.p0).position;
    journal.edit(mesh[grip.curve].handles[grip.is_at_end]).tangent.position = 3.0 * (to - from);
    plain.let_bend(grip.curve);
  }
  plain.refresh(journal, curves);
  for (const Halfedge curve : curves) check_in_frame(made.mesh, curve, problem.frame());
  check_protected(mesh, journal.mesh());
  return made;
}

EditedMesh recolored(const Mesh& mesh, const Pointed& pointed, const glm::dvec3& color,
                     bool is_sharp) {
  const std::vector<Halfedge> corners = corners_of(mesh, pointed, is_sharp);
  check_can_recolor(mesh, corners);
  EditedMesh made{mesh, is_sharp ? Message("Set the colour of a corner")
                                 : Message("Set the colour of a point")};
  made.redraws = true;
  Journal journal(made.mesh);
  for (const Halfedge corner : corners) recolor(journal, corner, {color, mesh[corner].color.a});
  return made;
}

EditedMesh joined(const Mesh& mesh, const Pointed& pointed) {
  const std::vector<Halfedge> corners = corners_of(mesh, pointed, false);
  check_can_recolor(mesh, corners);
  EditedMesh made{mesh, Message("Join the colours of a point")};
  made.redraws = true;
  Journal journal(made.mesh);
  join_colors(journal, mesh.origin(pointed.corner));
  if (made.mesh == mesh) throw InputError("this point has one colour already.");
  return made;
}

}  // namespace gradmesh
