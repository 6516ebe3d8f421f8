#pragma once

#include <vector>

#include "mesh/mesh.h"
#include "mesh/rectangle.h"

namespace gradmesh {

/// How a mesh is written as a group of blocks.
struct BlockForm {
  /// The blocks in the order in which they are painted: rectangles of patches without T-junctions
  /// or sharp colour edges inside, which is what one mesh gradient can hold.
  std::vector<Rectangle> blocks;
  /// The value of coons_tolerance (raster/frame.h).
  double coons_tolerance = 0;
  /// The decimal step of which all coordinates are multiples (form/rounding.h); 0 where significant
  /// digits are shorter.
  double step = 0;
  /// True if the opacities are in a mask over opaque blocks; otherwise the blocks hold them.
  bool masks_opacity = false;
};

/// Cuts the mesh into blocks: the largest rectangle (by patches) first, then the largest of what is
/// left. Every face is in exactly one block. The blocks are painted so that all faces lie over one
/// another as `overlaps` says; where that leaves a choice, those of the largest area come first, so
/// that a click finds the smaller ones. Neighbouring blocks both paint the pixels between them, and
/// where blocks lie over one another both are seen: so opacities are in a mask unless no such place
/// is translucent. Coordinates have a step that moves no point by more than a tenth of
/// `coons_tolerance`: how a curve runs that has T-junctions is read from its parts, which are off
/// by several times as much.
BlockForm block_form(const Mesh& mesh, double coons_tolerance,
                     const std::vector<Overlap>& overlaps = {});

/// Returns the patch with this top as a reader of these blocks finds it.
Patch written_patch(const Mesh& mesh, Halfedge top, const BlockForm& form);

/// Returns the mesh as a reader of these blocks finds it: patches as they will be written, in the
/// order in which they will be painted, and all curves.
MeshParts block_parts(const Mesh& mesh, const BlockForm& form);

}  // namespace gradmesh
