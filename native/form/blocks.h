#pragma once

#include <vector>

#include "form/written_patch.h"
#include "mesh/mesh.h"
#include "mesh/rectangle.h"

namespace gradmesh {

/// How a mesh is written: as a group of blocks, or as one mesh gradient, which is one block.
struct BlockForm {
  /// The blocks in the order in which they are painted: rectangles of patches without T-junctions
  /// or sharp colour edges inside, which is what one mesh gradient can hold.
  std::vector<Rectangle> blocks;
  Precision precision = {};
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
/// by several times as much. They have a finer one, or none, where that keeps what must stay as it
/// is (Mesh::is_fixed) to the last digit.
BlockForm block_form(const Mesh& mesh, double coons_tolerance,
                     const std::vector<Overlap>& overlaps = {});

/// A difference of colours that is no more than the rounding of both to 8 bits.
inline constexpr double rounding_of_colors = 1.001 / 255;

/// Returns true if all patches that meet at a point have one colour there, as one mesh gradient
/// holds them: channels that differ by at most `tolerance`.
bool has_one_color_at_each_point(const Mesh& mesh, double tolerance = rounding_of_colors);

/// Returns the form of a grid (find_grid) as one mesh gradient, in the coordinates to which
/// `to_gradient` maps. They have a step that moves no point by more than `coons_tolerance`, and a
/// finer one, or none, as block_form() says.
BlockForm gradient_form(const Mesh& mesh, double coons_tolerance, const Affine& to_gradient);
/// Returns the precision of that form where nothing must stay as it is.
Precision gradient_precision(double coons_tolerance, const Affine& to_gradient);

/// Returns the tolerance of the patch with this top: the last bits for the patch where it must stay
/// as it is, and for a side that is one of such a patch as well.
PatchTolerance patch_tolerance(const Mesh& mesh, Halfedge top, const Precision& precision);
/// Returns the patch with this top as a reader finds it.
Patch written_patch(const Mesh& mesh, Halfedge top, const BlockForm& form);

/// Returns the mesh as a reader finds it that is written in this form, in its own coordinates:
/// patches as they will be written, in the order in which they will be painted, and all curves.
MeshParts block_parts(const Mesh& mesh, const BlockForm& form);

}  // namespace gradmesh
