#include "mesh/mesh_hash.h"

namespace gradmesh {
namespace {

void add(Hash& hash, const Value& v) {
  for (int i = 0; i < 2; ++i) hash.add(v.position[i]);
  for (int i = 0; i < 4; ++i) hash.add(v.color[i]);
}

}  // namespace

void add(Hash& hash, const Mesh& mesh) {
  for (const Face f : mesh.faces()) {
    const Patch patch = mesh.patch(f);
    for (const auto& row : patch.c)
      for (const Value& v : row) add(hash, v);
    if (mesh.is_fixed(f)) hash.add(f.value);
    for (const Halfedge h : mesh.sides(f)) {
      hash.add(h.value);
      hash.add(mesh.curve(h).value);
    }
  }
}

}  // namespace gradmesh
