#pragma once

#include <array>
#include <vector>

#include "mesh/mesh.h"

namespace gradmesh {

/// A rectangle of faces without T-junctions or sharp colour edges inside: what one meshgradient
/// can hold.
struct Block {
  struct Cell {
    Face face;
    /// Which side of the face (counted as in Mesh::sides) is the top in the block.
    int top;

    bool operator==(const Cell&) const = default;
  };
  int rows = 0, columns = 0;
  /// Row by row.
  std::vector<Cell> cells;

  const Cell& cell(int row, int column) const { return cells[row * columns + column]; }
};

/// The half-edge of a cell that is side `side` (0 top, 1 right, 2 bottom, 3 left) in its block.
Halfedge block_side(const Mesh& mesh, const Block::Cell& cell, int side);
/// The cell's patch with the block's top as its top.
Patch block_patch(const Mesh& mesh, const Block::Cell& cell);

/// Cuts the mesh into blocks: the largest rectangle (by patches) first, then the largest of what is
/// left. Every face is in exactly one. The order is that of painting: those of the largest area
/// lie below, so that a click finds the smaller ones.
std::vector<Block> find_blocks(const Mesh& mesh);

/// The ways to write a mesh: those blocks in the order above, and each where its first face comes
/// in the order of the mesh, for meshes that lie over themselves, where the order is seen.
std::array<std::vector<Block>, 2> possible_blocks(const Mesh& mesh);

/// The mesh as a reader of these blocks finds it: patches as they will be written, in the order
/// in which they will be painted, and all curves.
MeshParts block_parts(const Mesh& mesh, const std::vector<Block>& blocks, double coons_tolerance);

}  // namespace gradmesh
