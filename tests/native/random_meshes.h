#pragma once

#include <vector>

#include "meshes.h"
#include "ops/merge/merge.h"
#include "ops/split/split.h"

namespace gradmesh::test {

/// A random merge or, with a chance of one in `split_chance` and where nothing can be merged, a
/// random split, as one operation of the journal.
inline void change_at_random(Journal& journal, std::mt19937& random, unsigned split_chance = 4) {
  const Mesh& mesh = journal.mesh();
  std::vector<Halfedge> edges, leaves;
  for (const Halfedge h : mesh.halfedges()) {
    if (mesh.is_leaf(h)) leaves.push_back(h);
    if (can_merge(mesh, h) == MergeObstacle::none) edges.push_back(h);
  }
  if (random() % split_chance == 0 || edges.empty()) {
    split(journal, leaves[random() % leaves.size()], 0.3 + 0.4 * double(random() % 1000) / 1000);
  } else {
    merge(journal, edges[random() % edges.size()]);
  }
}

/// A mesh with T-junctions, nested ones among them: parts changed at random.
inline Mesh changed_mesh(const MeshParts& parts, unsigned seed, int steps,
                         unsigned split_chance = 4) {
  std::mt19937 random(seed);
  Mesh mesh = build_mesh(parts);
  Journal journal(mesh);
  for (int i = 0; i < steps; ++i) change_at_random(journal, random, split_chance);
  return mesh;
}

/// The mesh without what MeshParts and files cannot hold.
inline Mesh without_own_tangents(Mesh mesh) {
  Journal journal(mesh);
  journal.begin();
  for (const Halfedge h : mesh.halfedges()) journal.edit(h).own_tangents = {};
  return mesh;
}

/// One patch, locally refined by exact splits until it has so many: T-junctions, nested ones among
/// them, that can all go again.
inline Mesh locally_refined(ColorModel model, unsigned seed, int patches) {
  Mesh mesh =
      grid_mesh({.rows = 1, .columns = 1, .position_noise = 0.2, .color_model = model}, seed);
  std::mt19937 random(seed);
  Journal journal(mesh);
  while (mesh.face_count() < patches) {
    std::vector<Halfedge> leaves;
    for (const Halfedge h : mesh.halfedges())
      if (mesh.is_leaf(h)) leaves.push_back(h);
    split(journal, leaves[random() % leaves.size()], 0.3 + 0.4 * double(random() % 1000) / 1000);
  }
  return mesh;
}

}  // namespace gradmesh::test
