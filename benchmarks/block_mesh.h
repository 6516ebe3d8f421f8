#pragma once

#include "mesh/mesh.h"

namespace gradmesh::bench {

/// Patches along one side of a block.
inline constexpr int block_side = 5;

/// A square of blocks of 5 x 5 patches each, `blocks` along each side, 125 units a block. Every
/// block is one smooth patch divided exactly, under colours that are smooth over the whole mesh;
/// blocks meet in T-junctions, so that no region reaches beyond one. Larger meshes have more
/// blocks, never larger ones: what a region costs does not grow with the mesh.
Mesh block_mesh(int blocks);

}  // namespace gradmesh::bench
