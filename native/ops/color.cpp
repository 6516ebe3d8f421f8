#include "ops/color.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "mesh/dependence.h"
#include "ops/refresh.h"

namespace gradmesh {
namespace {

/// Returns the curves whose colours depend on that of a corner: it is an end of both.
std::array<Halfedge, 2> curves_of(const Mesh& mesh, Halfedge corner) {
  return {mesh.curve(corner), mesh.curve(mesh.prev(corner))};
}

void set(Journal& journal, Halfedge corner, const glm::dvec4& color, bool is_own) {
  HalfedgeRecord& record = journal.edit(corner);
  record.color = color;
  record.own_color = is_own;
  journal.touch(journal.mesh().face(corner));
}

}  // namespace

std::vector<Halfedge> corners_at(const Mesh& mesh, Point point) {
  std::vector<Halfedge> corners;
  for (const Halfedge h : mesh.halfedges())
    if (mesh.is_leaf(h) && mesh.origin(h) == point) corners.push_back(h);
  return corners;
}

bool can_recolor(const Mesh& mesh, Halfedge corner) {
  if (mesh.is_fixed(mesh.face(corner))) return false;
  // The T-junctions of these curves follow, and with them the corners of the patches along divided
  // sides.
  for (const Halfedge curve : in_order_of_dependence(mesh, curves_of(mesh, corner)))
    for (const Halfedge side : {curve, mesh[curve].twin})
      if (side.valid() && mesh.is_parent(side))
        for (const Halfedge leaf : mesh.leaves(side))
          if (mesh.is_fixed(mesh.face(leaf))) return false;
  return true;
}

void recolor(Journal& journal, Halfedge corner, const glm::dvec4& color) {
  assert(can_recolor(journal.mesh(), corner));
  journal.begin();
  set(journal, corner, color, true);
  refresh(journal, curves_of(journal.mesh(), corner));
}

void join_colors(Journal& journal, Point point) {
  const Mesh& mesh = journal.mesh();
  const std::vector<Halfedge> corners = corners_at(mesh, point);
  glm::dvec4 mean(0);
  for (const Halfedge corner : corners) mean += mesh[corner].color / double(corners.size());
  journal.begin();
  std::vector<Halfedge> curves;
  for (const Halfedge corner : corners) {
    set(journal, corner, mean, !mesh[point].is_junction());
    for (const Halfedge curve : curves_of(mesh, corner)) curves.push_back(curve);
  }
  if (mesh[point].is_junction()) curves.push_back(mesh.curve(mesh[mesh[point].stem].parent));
  refresh(journal, curves);
}

}  // namespace gradmesh
