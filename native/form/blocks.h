#pragma once

#include <vector>

#include "mesh/mesh.h"

namespace gradmesh {

/// A rectangle of faces without T-junctions or sharp colour edges inside: what one meshgradient can
/// hold.
struct Block {
  struct Cell {
    Face face;
    /// The side of the face (counted as in Mesh::sides) that is the top in the block.
    int top;

    bool operator==(const Cell&) const = default;
  };
  int rows = 0, columns = 0;
  /// The cells, row by row.
  std::vector<Cell> cells;

  const Cell& cell(int row, int column) const { return cells[row * columns + column]; }
};

/// Returns the half-edge of a cell that is side `side` (0 top, 1 right, 2 bottom, 3 left) in its
/// block.
Halfedge block_side(const Mesh& mesh, const Block::Cell& cell, int side);
/// Returns the cell's patch with the block's top as its top.
Patch block_patch(const Mesh& mesh, const Block::Cell& cell);

/// How a mesh is written as a group of blocks.
struct BlockForm {
  /// The blocks in the order in which they are painted.
  std::vector<Block> blocks;
  /// The value of coons_tolerance (raster/frame.h).
  double coons_tolerance = 0;
  /// True if the opacities are in a mask over opaque blocks; otherwise the blocks hold them.
  bool masks_opacity = false;
};

/// Cuts the mesh into blocks: the largest rectangle (by patches) first, then the largest of what is
/// left. Every face is in exactly one block. The blocks are painted so that all faces lie over one
/// another as `overlaps` says; where that leaves a choice, those of the largest area come first, so
/// that a click finds the smaller ones. Neighbouring blocks both paint the pixels between them, and
/// where blocks lie over one another both are seen: so opacities are in a mask unless no such place
/// is translucent.
BlockForm block_form(const Mesh& mesh, double coons_tolerance,
                     const std::vector<Overlap>& overlaps = {});

/// Returns the mesh as a reader of these blocks finds it: patches as they will be written, in the
/// order in which they will be painted, and all curves.
MeshParts block_parts(const Mesh& mesh, const BlockForm& form);

}  // namespace gradmesh
