#pragma once

#include <optional>
#include <vector>

#include "form/reconcile.h"
#include "mesh/parts.h"

namespace gradmesh {

/// For each row and column of a block, the places in (0, 1) where it is cut, rising.
struct BlockCuts {
  std::vector<std::vector<double>> rows, columns;
};

/// Returns where somebody has cut the rows and columns of a block, of which points may have been
/// moved before and since, or the block as a whole, scaled, turned or sheared. `read` has at least
/// as many rows and columns as `written`. Returns nothing where several lines may be new as well.
///   - The lines of before are those that lie nearest to them, in the same order.
///   - A new line is where most of its points lie on the curves of before, and divide those of now.
std::optional<BlockCuts> find_cuts(const PatchGrid& written, const PatchGrid& read);

/// Returns the block with its patches cut, exactly (A.1).
PatchGrid cut(const PatchGrid& block, const BlockCuts& cuts);

/// The blocks of a mesh as a person has left them.
struct EditedBlocks {
  /// Those that were removed are as they were written.
  std::vector<PatchGrid> read;
  /// How they were written, each with how it was cut since, and whether it was removed. None if
  /// that is not known.
  std::vector<PatchGrid> written;
  std::vector<BlockCuts> cuts;
  std::vector<bool> removed;
  /// The curves between blocks, with patches numbered as those of `written`, if it is known.
  std::vector<CurveParts> curves;
};

/// Returns the numbers of the patches of blocks that were removed, as parts_of() numbers those
/// read.
std::vector<int> removed_patches(const EditedBlocks& blocks);

/// Returns reconcile() of the blocks, removed ones among them. New lines end at T-junctions of the
/// curves between blocks, and where lines from both sides meet, a curve is cut. Throws InputError
/// as build_mesh.
Reconciled reconcile(const EditedBlocks& blocks);

}  // namespace gradmesh
