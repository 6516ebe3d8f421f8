#pragma once

#include <iterator>
#include <set>

#include "form/blocks.h"
#include "form/cut_blocks.h"
#include "form/written_patch.h"
#include "mesh/subdivide.h"
#include "random_meshes.h"

namespace gradmesh::test {

/// The parts changed at random, with patches as they will be written.
inline MeshParts written_parts(MeshParts parts, unsigned seed, int steps = 20) {
  for (Patch& patch : parts.patches) patch = as_written(patch, 0);
  return subdivided(changed_mesh(parts, seed, steps), 1);
}

/// A random grid of 400 x 400 units, changed so.
inline MeshParts written_parts(unsigned seed) {
  std::mt19937 random(seed);
  return written_parts(
      grid_parts({.rows = 4, .columns = 4, .position_noise = 0.05, .color_noise = 0.2}, random),
      seed);
}

/// A mesh as it is written in blocks, with the cuts of a person, who has made none yet.
inline EditedBlocks written_blocks(const MeshParts& written) {
  const Mesh mesh = build_mesh(written);
  const BlockForm form = block_form(mesh, 0);
  const MeshParts parts = block_parts(mesh, form);
  EditedBlocks blocks;
  auto patch = parts.patches.begin();
  for (const Rectangle& block : form.blocks) {
    const auto end = patch + block.rows * block.columns;
    blocks.written.push_back({block.rows, block.columns, {patch, end}});
    blocks.cuts.push_back({std::vector<std::vector<double>>(std::size_t(block.rows)),
                           std::vector<std::vector<double>>(std::size_t(block.columns))});
    patch = end;
  }
  blocks.read = blocks.written;
  blocks.removed.assign(blocks.read.size(), false);
  std::set<int> inside;
  for (const CurveParts& curve : parts_of(blocks.written).curves)
    inside.insert({curve.a.halfedges[0], curve.b.halfedges[0]});
  for (const CurveParts& curve : parts.curves)
    if (!inside.contains(curve.a.halfedges[0])) blocks.curves.push_back(curve);
  return blocks;
}

}  // namespace gradmesh::test
