#pragma once

#include <vector>

#include "mesh/region.h"
#include "ops/journal.h"

namespace gradmesh {

/// Makes the patch one step larger, over its side of that number (as in Mesh::sides): merges it
/// with what lies across the whole of that curve, and before that whatever hangs on the curve, and
/// on that in turn. So it then covers the smallest area bounded by four curves that has the curve
/// inside. Each merge is one operation of the journal. Returns false where one of them cannot be
/// made (can_merge), after those before it.
bool grow(Journal& journal, Face face, int side);

/// The view in which a region is merged: where no T-junction is inside, along its longer direction
/// first, which has turned out to change the mesh less. So it has at least as many columns as rows.
Region merging_view(const Mesh& mesh, const Region& region);

/// Merges a region into one patch, as one operation of the journal for each merge: in its
/// merging_view row by row, each along itself and then with the rows above. Returns the patch, or
/// an invalid one where a merge cannot be made (can_merge): then nothing is changed.
Face merge_region(Journal& journal, const Region& region);

/// Merges one region after another, each alone, and keeps the rows that the next has in common
/// with it. So regions that grow by rows cost one row each, if they are asked for by the face, top,
/// columns and rows of their merging_view.
class RegionMerger {
 public:
  /// `start` is the journal's mesh as it is now, and stays so. As long as a region is merged, the
  /// journal is not to be changed by others.
  RegionMerger(Journal& journal, const Mesh& start)
      : journal_(journal), start_(start), depths_{journal.depth()} {}

  /// Leaves the journal with this region of `start` merged, as by merge_region, and no other. False
  /// where there is no such region or it cannot be merged: then nothing is merged.
  bool merge(const Region& region);
  /// Takes all back.
  void undo() { keep_rows(0); }

 private:
  bool merge_row();
  void keep_rows(int rows);

  Journal& journal_;
  const Mesh& start_;
  /// What is merged.
  Region view_;
  /// The journal's depth before anything, and after each row that is merged.
  std::vector<std::size_t> depths_;
};

}  // namespace gradmesh
