#pragma once

#include <vector>

#include "mesh/region.h"
#include "ops/journal.h"

namespace gradmesh {

/// Makes the patch one step larger across its side of number `side` (as in Mesh::sides, modulo 4):
/// merges the patch with those across the whole curve of that side, after the curves that depend on
/// that curve as stems, directly or not, have been merged away. The patch then covers the smallest
/// area bounded by four curves that has the curve inside. Each merge is one operation of the
/// journal. Returns false at the first merge that cannot be made (can_merge); the merges before it
/// stay.
bool grow(Journal& journal, Face face, int side);

/// Returns the view in which a region is merged: where no T-junction is inside, along its longer
/// direction first, which has turned out to change the mesh less. Such a view has at least as many
/// columns as rows.
Region merging_view(const Mesh& mesh, const Region& region);

/// Merges one region after another, each alone, and keeps the rows that the next has in common with
/// it. So regions that grow by rows cost one row each, if the face, top, columns and rows of their
/// merging_view are given.
class RegionMerger {
 public:
  /// `start` equals the journal's mesh as it is now, and does not change. As long as a region is
  /// merged, nothing else may change the journal.
  RegionMerger(Journal& journal, const Mesh& start)
      : journal_(journal), start_(start), depths_{journal.depth()} {}

  /// Leaves the journal with this region of `start` merged, and no other, and returns the patch.
  /// Returns an invalid face if there is no such region or it cannot be merged; then nothing is
  /// merged.
  Face merge(const Region& region);
  /// Undoes all merges.
  void undo() { keep_rows(0); }

 private:
  bool merge_row();
  void keep_rows(int rows);

  Journal& journal_;
  const Mesh& start_;
  /// The merging_view of the region that is merged.
  Region view_;
  /// The journal's depth before any merge, and after each row that is merged.
  std::vector<std::size_t> depths_;
};

/// Merges a region into one patch, as one operation of the journal for each merge: in its
/// merging_view row by row, each row along itself and then with the rows above. Returns the patch.
/// Where a merge cannot be made (can_merge), changes nothing and returns an invalid face.
inline Face merge_region(Journal& journal, const Region& region) {
  return RegionMerger(journal, journal.mesh()).merge(region);
}

}  // namespace gradmesh
