#include "ops/fix.h"

namespace gradmesh {

void set_fixed(Journal& journal, const std::vector<Face>& faces, bool is_fixed) {
  journal.begin();
  for (const Face face : faces) journal.edit(face).fixed = is_fixed;
}

bool are_same_but_for_fixed(const Mesh& a, const Mesh& b) {
  const auto without_fixed = [](Mesh mesh) {
    Journal journal(mesh);
    set_fixed(journal, {mesh.faces().begin(), mesh.faces().end()}, false);
    return mesh;
  };
  return a.face_slots() == b.face_slots() && without_fixed(a) == without_fixed(b);
}

Mesh with_fixed(Mesh mesh, const std::vector<Face>& faces) {
  Journal journal(mesh);
  set_fixed(journal, faces, true);
  return mesh;
}

}  // namespace gradmesh
