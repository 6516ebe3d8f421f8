#pragma once

#include <string>
#include <vector>

#include "meshes.h"
#include "ops/merge/merge.h"
#include "ops/merge/split_share.h"
#include "ops/split/split.h"

namespace gradmesh::test {

/// What validate() says of a sound mesh.
inline const std::vector<std::string> sound;

inline std::vector<Halfedge> all_leaves(const Mesh& mesh) {
  std::vector<Halfedge> leaves;
  for (const Halfedge h : mesh.halfedges())
    if (mesh.is_leaf(h)) leaves.push_back(h);
  return leaves;
}

/// The split factor of an edge, with its ends.
inline double split_factor(const Mesh& mesh, Halfedge edge) {
  return split_factor(mesh, edge, merge_end(mesh, edge), merge_end(mesh, mesh[edge].twin));
}

inline std::vector<Halfedge> mergeable_edges(const Mesh& mesh) {
  std::vector<Halfedge> edges;
  for (const Halfedge h : mesh.halfedges())
    if (can_merge(mesh, h) == MergeObstacle::none) edges.push_back(h);
  return edges;
}

inline void split_at_random(Journal& journal, std::mt19937& random) {
  const std::vector<Halfedge> leaves = all_leaves(journal.mesh());
  split(journal, leaves[random() % leaves.size()], 0.3 + 0.4 * double(random() % 1000) / 1000);
}

/// A random merge or, with a chance of one in `split_chance` and where nothing can be merged, a
/// random split, as one operation of the journal.
inline void change_at_random(Journal& journal, std::mt19937& random, unsigned split_chance = 4) {
  const std::vector<Halfedge> edges = mergeable_edges(journal.mesh());
  if (random() % split_chance == 0 || edges.empty())
    split_at_random(journal, random);
  else
    merge(journal, edges[random() % edges.size()]);
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
  while (mesh.face_count() < patches) split_at_random(journal, random);
  return mesh;
}

}  // namespace gradmesh::test
