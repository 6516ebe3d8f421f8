#include "ops/refresh.h"

#include "mesh/dependence.h"

namespace gradmesh {
namespace {

void refresh_junction(Journal& journal, Halfedge stem) {
  const Mesh& mesh = journal.mesh();
  const Value value = junction_value(mesh, stem);
  journal.edit(mesh.origin(stem)).position = value.position;
  for (const Halfedge leaf : {mesh.first_leaf(stem), mesh[stem].next_sibling})
    if (!mesh[leaf].own_color) journal.edit(leaf).color = value.color;
}

}  // namespace

void refresh_curve(Journal& journal, Halfedge curve) {
  const Mesh& mesh = journal.mesh();
  for (const Halfedge side : {curve, mesh[curve].twin})
    if (side.valid())
      for (const Halfedge stem : mesh.stems(side)) refresh_junction(journal, stem);
  journal.touch_curve(curve);
}

void refresh(Journal& journal, std::span<const Halfedge> changed_curves) {
  for (const Halfedge curve : in_order_of_dependence(journal.mesh(), changed_curves))
    refresh_curve(journal, curve);
}

}  // namespace gradmesh
