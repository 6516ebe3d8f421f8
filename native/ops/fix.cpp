#include "ops/fix.h"

namespace gradmesh {

void set_fixed(Journal& journal, const std::vector<Face>& faces, bool is_fixed) {
  journal.begin();
  for (const Face face : faces) journal.edit(face).fixed = is_fixed;
}

Mesh with_fixed(Mesh mesh, const std::vector<Face>& faces) {
  Journal journal(mesh);
  set_fixed(journal, faces, true);
  return mesh;
}

}  // namespace gradmesh
