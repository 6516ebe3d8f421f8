#include "ops/straighten.h"

namespace gradmesh {

void straighten(Journal& journal, Halfedge curve) {
  const Mesh& mesh = journal.mesh();
  const glm::dvec2 chord = mesh.position(mesh.end(curve)) - mesh.position(mesh.origin(curve));
  const auto [start, end] = mesh[curve].handles;
  journal.edit(start).tangent.position = chord;
  journal.edit(end).tangent.position = -chord;
}

void drop_tensor(Journal& journal, Face face) {
  const Mesh& mesh = journal.mesh();
  Patch patch = mesh.patch(face);
  make_coons(patch);
  const std::array<Halfedge, 4> sides = mesh.sides(face);
  for (int k = 0; k < 4; ++k)
    journal.edit(sides[std::size_t(k)]).twist.position = patch.twist(k).position;
  journal.touch(face);
}

}  // namespace gradmesh
